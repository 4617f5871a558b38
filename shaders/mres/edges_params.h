// Thresholds of the edge detector: read by C++ and GLSL.
#pragma once
#include "common/params.h"

BEGIN_PARAMS

UNIFORM_BLOCK(EdgesParams) {
    float normalDifference2;  // normals, as encoded, that differ by more (squared) are an edge
    float depthThreshold;     // metres
    float edgesPadding0;
    float edgesPadding1;
};

END_PARAMS
