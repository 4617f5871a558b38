// Thresholds of the edge detector: read by C++ and GLSL.
#pragma once
#include "common/params.h"

BEGIN_PARAMS

UNIFORM_BLOCK(EdgesParams) {
    vec4 depthSlope;        // |d view depth / d window depth| = .x / (.y + .z * window depth)^2
    float normalDifference2;  // normals, as encoded, that differ by more (squared) are an edge
    float depthThreshold;   // metres
    vec2 depthRounding;     // window-depth differences up to .x + .y * window depth are rounding
};

END_PARAMS
