#version 330 core
// The zone of a level, one texel a block of 4x4 of its pixels: above zero where the effect renders. That is where the
// mask is above zero for any pixel of the block and, with PROGRESSIVE, where the coarser level showed in it that
// refining makes a difference. Whole blocks, since rasterisers shade whole blocks or quads anyway.
#include "mres/frame_params.h"
#include "mres/level.glsl"

uniform sampler2D maskTexture;
uniform sampler2D refineTexture;

out float fragment;

void main() {
    vec2 low = floor(gl_FragCoord.xy) * float(ZONE_BLOCK * levelStride);
    vec2 high = low + float(ZONE_BLOCK * levelStride);
    fragment = largestAtCorners(maskTexture, low * maskFromPixel, high * maskFromPixel);
#if PROGRESSIVE
    fragment = min(fragment, largestAtCorners(refineTexture, low * coarserFromPixel, high * coarserFromPixel));
#endif
    fragment = fragment > 0.0 ? 1.0 : 0.0;
}
