// One resolution level: read by C++ and GLSL.
#pragma once
#include "common/params.h"

#define ZONE_BLOCK 4  // pixels: llvmpipe shades blocks of 4x4, GPUs quads of 2x2

BEGIN_PARAMS

UNIFORM_BLOCK(LevelParams) {
    ivec2 levelSize;       // pixels of this level
    int levelStride;       // 2^level: full-resolution pixels per pixel of this level
    int levelHalfStride;   // half of it, 0 for full resolution
    vec2 coarserFromPixel; // texture coordinate in the coarser level per full-resolution pixel
    vec2 maskFromPixel;    // texture coordinate in the mask per full-resolution pixel
    float blendWeight;     // w_i of equation 1, [1, 1000]
    float refineThreshold; // difference that is worth rendering a finer level for
    vec2 zoneFromPixel;    // texture coordinate in the zone per pixel of this level
    vec4 lastInterval;     // the last texel of the coarser level stands nearer: beyond pixel .xy, pixels count .zw more
    int noisePeriod;       // pixels of this level after which what is random repeats, 1..4
    int levelJitter;       // 1: pixels are evaluated by turns at the four around their block's centre; 0: all at one of them
    int coarserJitter;     // levelJitter of the coarser level, whose values it moves half a pixel down and left
    int coarserStride;     // levelStride of the coarser level
};

END_PARAMS
