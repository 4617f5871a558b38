#pragma once
#include "common/params.h"

// Rows of an affine map of texture coordinates.
#define UV_ROWS 2

BEGIN_PARAMS
UNIFORM_BLOCK(MaterialParams) {
  vec4 baseColorFactor;
  vec4 emissiveFactor;                  // rgb, w unused
  vec4 baseColorUv[UV_ROWS];            // u = dot(row 0, (uv, 1)), v = dot(row 1, (uv, 1))
  vec4 metallicRoughnessUv[UV_ROWS];
  vec4 normalUv[UV_ROWS];
  vec4 emissiveUv[UV_ROWS];
  float metallicFactor;
  float roughnessFactor;
  float normalScale;                    // 0 without a normal map
  float alphaCutoff;                    // fragments below are discarded; 0 discards none
};
END_PARAMS
