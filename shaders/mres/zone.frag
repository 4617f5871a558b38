#version 330 core
// The zone of a level, one texel a block of 4x4 of its pixels: above zero where the effect renders. That is where the
// mask is above zero for any pixel of the block and, with PROGRESSIVE, where the coarser level showed next to it that
// refining makes a difference. Whole blocks, since rasterisers shade whole blocks or quads anyway.
#include "mres/frame_params.h"
#include "mres/level.glsl"

uniform sampler2D maskTexture;
uniform sampler2D refineTexture;

out float fragment;

// Bilinear samples at a block's corners see every texel that a bilinear sample inside of the block may see.
float largestAtCorners(sampler2D blockTexture, vec2 low, vec2 high) {
    return max(max(texture(blockTexture, low).r, texture(blockTexture, vec2(high.x, low.y)).r),
               max(texture(blockTexture, vec2(low.x, high.y)).r, texture(blockTexture, high).r));
}

void main() {
    vec2 low = floor(gl_FragCoord.xy) * float(ZONE_BLOCK * levelStride);
    vec2 high = low + float(ZONE_BLOCK * levelStride);
    fragment = largestAtCorners(maskTexture, low * maskFromPixel, high * maskFromPixel);
#if PROGRESSIVE
    fragment = min(fragment, largestAtCorners(refineTexture, low * coarserFromPixel, high * coarserFromPixel));
#endif
    fragment = fragment > 0.0 ? 1.0 : 0.0;
}
