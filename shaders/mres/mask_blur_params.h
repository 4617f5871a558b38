// A Gaussian along one axis: read by C++ and GLSL.
#pragma once
#include "common/params.h"

#define MASK_BLUR_MAX_RADIUS 15

BEGIN_PARAMS

UNIFORM_BLOCK(MaskBlurParams) {
    ivec2 axis;     // (1, 0) or (0, 1)
    int radius;     // taps on each side, 0..MASK_BLUR_MAX_RADIUS
    int finerRatio; // texels of the finer level's mask per texel, along one axis
    vec4 weights[(MASK_BLUR_MAX_RADIUS + 4) / 4];  // of distance 0, 1, 2, ...
};

END_PARAMS
