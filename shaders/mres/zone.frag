#version 330 core
// The zone of a level, one texel a block of 4x4 of its pixels: above zero where the effect renders. That is where the
// mask is above zero for any pixel of the block and, with PROGRESSIVE, where the coarser level showed next to it that
// refining makes a difference. Whole blocks, since rasterisers shade whole blocks or quads anyway.
#include "mres/frame_params.h"
#include "mres/level.glsl"

uniform sampler2D maskTexture;
uniform sampler2D refineTexture;

out float fragment;

// Bilinear samples see every texel that one inside of the block may see, if it is no larger than four texels.
float largestIn(sampler2D source, vec2 low, vec2 high) {
    float largest = 0.0;
    for (int i = 0; i < 9; ++i) {
        largest = max(largest, texture(source, mix(low, high, 0.5 * vec2(i % 3, i / 3))).r);
    }
    return largest;
}

void main() {
    vec2 low = floor(gl_FragCoord.xy) * float(ZONE_BLOCK * levelStride);
    vec2 high = low + float(ZONE_BLOCK * levelStride);
    fragment = largestAtCorners(maskTexture, low * maskFromPixel, high * maskFromPixel);
#if PROGRESSIVE
    low = low * coarserFromPixel - refineReach;
    high = high * coarserFromPixel + refineReach;
    fragment = min(fragment, largestIn(refineTexture, low, high));
#endif
    fragment = fragment > 0.0 ? 1.0 : 0.0;
}
