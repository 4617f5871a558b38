// Screen-space ambient occlusion: read by C++ and GLSL.
#pragma once

#include "common/params.h"

#define SSAO_MAX_SAMPLES 256

BEGIN_PARAMS

UNIFORM_BLOCK(SsaoParams) {
    float radius;          // metres. Reach of the occlusion.
    float bias;            // share of the radius that a surface must rise above the tangent plane to occlude
    float intensity;       // multiplies occlusion
    int sampleCount;       // 1..SSAO_MAX_SAMPLES
    vec4 samples[SSAO_MAX_SAMPLES];  // xyz in the unit hemisphere around +Z; w = log2 of its length
};

END_PARAMS
