// How the pixels of a level relate to those of the full resolution.
#include "mres/level_params.h"

// A level's pixel stands for a stride x stride block and is evaluated at exactly one full-resolution pixel, the
// one up and right of the block's centre. No G-buffer is down-sampled: position, depth and normal always belong
// together, and the upsampling below knows where each value sits.
ivec2 representativePixel(ivec2 levelPixel, ivec2 fullSize) {
    return min(levelPixel * levelStride + levelHalfStride, fullSize - 1);
}

vec2 coarserCoordinate(ivec2 fullPixel) {
    vec2 pixel = vec2(fullPixel);
    return (pixel + max(pixel - lastInterval.xy, 0.0) * lastInterval.zw) * coarserFromPixel;
}

// Bilinear samples at the corners of a block no larger than two texels see every texel that one inside of it may see.
float largestAtCorners(sampler2D source, vec2 low, vec2 high) {
    return max(max(texture(source, low).r, texture(source, vec2(high.x, low.y)).r),
               max(texture(source, vec2(low.x, high.y)).r, texture(source, high).r));
}

vec2 zoneCoordinate(ivec2 levelPixel) {
    return (vec2(levelPixel) + 0.5) * zoneFromPixel;
}

vec2 maskCoordinate(ivec2 fullPixel) {
    return (vec2(fullPixel) + 0.5) * maskFromPixel;
}
