// The shadow map of the light that casts shadows.
#pragma once
#include "common/params.h"

BEGIN_PARAMS
UNIFORM_BLOCK(ShadowParams) {
  mat4 worldToShadow;       // camera-relative world to the shadow map's uv and depth, all 0..1 after division by w
  float shadowTexel;        // 1 / size of the shadow map
  float shadowTexelMetres;  // side of a texel where w is 1
  float shadowPadding0;
  float shadowPadding1;
};
END_PARAMS
