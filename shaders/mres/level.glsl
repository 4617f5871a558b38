// How the pixels of a level relate to those of the full resolution.
#include "mres/level_params.h"

// A level's pixel stands for a stride x stride block and is evaluated at exactly one full-resolution pixel, the
// one up and right of the block's centre. No G-buffer is down-sampled: position, depth and normal always belong
// together, and the upsampling below knows where each value sits.
ivec2 representativePixel(ivec2 levelPixel, ivec2 fullSize) {
    return min(levelPixel * levelStride + levelHalfStride, fullSize - 1);
}

vec2 coarserCoordinate(ivec2 fullPixel) {
    return vec2(fullPixel) * coarserFromPixel;
}

// The coarser level's word on where refining it shows, 0..1.
float refinement(sampler2D refineTexture, ivec2 fullPixel) {
    return min(2.0 * texture(refineTexture, coarserCoordinate(fullPixel)).r, 1.0);
}

vec2 maskCoordinate(ivec2 fullPixel) {
    return (vec2(fullPixel) + 0.5) * maskFromPixel;
}
