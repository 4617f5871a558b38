// The lights, as KHR_lights_punctual defines them. The first one may cast shadows.
#pragma once
#include "common/params.h"

#define MAX_LIGHTS 64

BEGIN_PARAMS
UNIFORM_BLOCK(LightParams) {
  vec4 lightPosition[MAX_LIGHTS];   // xyz camera-relative, w = 1 / range, 0 where unlimited; w < 0 is directional
  vec4 lightIntensity[MAX_LIGHTS];  // rgb candela (lux for directional lights), w = scale of the cone's cosine
  vec4 lightDirection[MAX_LIGHTS];  // xyz the way the light travels, w = offset of the cone's cosine
  int lightCount;
  int shadowedLights;               // 1 if the first one does, else 0
  int lightPadding0;
  int lightPadding1;
};
END_PARAMS
