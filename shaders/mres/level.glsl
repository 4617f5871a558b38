// How the pixels of a level relate to those of the full resolution.
#include "mres/level_params.h"

// A level's pixel stands for a stride x stride block and is evaluated at exactly one full-resolution pixel, one of the
// four around the block's centre. No G-buffer is down-sampled: position, depth and normal always belong together.
//
// With jitter, which of the four it is repeats every two pixels: rows take turns along a row, and columns along a column.
// So a row or column of one full-resolution pixel's width meets every other pixel of the half level; where all lay on
// odd rows, it would meet every one or none.
ivec2 representativePixel(ivec2 levelPixel, ivec2 fullSize) {
    return min(levelPixel * levelStride + levelHalfStride - (levelPixel.yx & levelJitter), fullSize - 1);
}

// That of a pixel of the coarser level.
ivec2 coarserRepresentativePixel(ivec2 coarserPixel, ivec2 fullSize) {
    return min(coarserPixel * coarserStride + (coarserStride >> 1) - (coarserPixel.yx & coarserJitter), fullSize - 1);
}

// The full-resolution pixel that a level pixel's value is of, which may lie between pixels: the filter takes the mean over
// the jitter. Where it finds no neighbours, beyond steps, values are half a pixel off. The upsampling below knows where each
// value of the coarser level sits.
vec2 placeOf(ivec2 levelPixel, ivec2 fullSize) {
    vec2 place = vec2(levelPixel * levelStride + levelHalfStride) - 0.5 * float(levelJitter);
    return min(place, vec2(fullSize - 1));
}

vec2 coarserCoordinate(vec2 place) {
    vec2 between = max(place - lastInterval.xy, 0.0) * lastInterval.zw;
    return (place + between + 0.5 * float(coarserJitter)) * coarserFromPixel;
}

// Bilinear samples at the corners of a block no larger than two texels see every texel that one inside of it may see.
float largestAtCorners(sampler2D source, vec2 low, vec2 high) {
    return max(max(texture(source, low).r, texture(source, vec2(high.x, low.y)).r),
               max(texture(source, vec2(low.x, high.y)).r, texture(source, high).r));
}

vec2 zoneCoordinate(ivec2 levelPixel) {
    return (vec2(levelPixel) + 0.5) * zoneFromPixel;
}

vec2 maskCoordinate(vec2 place) {
    return (place + 0.5) * maskFromPixel;
}
