// Soft shadow mapping: read by C++ and GLSL.
#pragma once

#include "common/params.h"

#define SOFT_SHADOWS_MAX_SAMPLES 1024
#define SOFT_SHADOWS_BLOCKER_SAMPLES 32
#define SOFT_SHADOWS_PREVIEW_SAMPLES 16

BEGIN_PARAMS

UNIFORM_BLOCK(SoftShadowsParams) {
    vec4 shadowU;         // dot with (view position, 1): texture coordinate in the shadow map, 0..1, times w
    vec4 shadowV;
    vec4 shadowDepth;     // ... window depth in the shadow map, 0..1, times w
    vec4 shadowW;         // ... w: the distance from a spot light, 1 for parallel light
    vec4 light;           // view space: direction to the light and 0, or its position and 1
    vec2 shadowMapSize;   // texels; 0 without a shadow map
    vec2 mapDistance;     // distance from a spot light = .y / (window depth - .x); .y is 0 for parallel light
    float filterRadius;   // metres across the light; with PCSS the largest
    float penumbraScale;  // radius of the penumbra per metre between blocker and receiver (parallel light), or radius of
                          // the light in metres; 0: no PCSS
    float bias;           // share of the filter's radius by which a blocker must rise above the receiver's plane
    int sampleCount;      // 1..SOFT_SHADOWS_MAX_SAMPLES
};

UNIFORM_BLOCK(SoftShadowsSamples) {
    vec4 samples[SOFT_SHADOWS_MAX_SAMPLES / 2];                // points in the unit disk, two each
    vec4 blockerSamples[SOFT_SHADOWS_BLOCKER_SAMPLES];         // one each
    vec4 previewSamples[SOFT_SHADOWS_PREVIEW_SAMPLES];
};

END_PARAMS
