// The one directional light that casts shadows.
#pragma once
#include "common/params.h"

BEGIN_PARAMS
UNIFORM_BLOCK(SunParams) {
  mat4 worldToShadow;    // camera-relative world to the shadow map's uv and depth, all 0..1
  vec4 directionToSun;   // xyz unit length
  vec4 sunIlluminance;   // rgb, lux; zero without a sun
  float shadowTexel;     // 1 / size of the shadow map
  float shadowTexelMetres;
  float sunPadding0;
  float sunPadding1;
};
END_PARAMS
