#version 330 core
// The zone of a level, one texel a block of 4x4 of its pixels: above zero where the effect renders, for any of the reasons
// that are defined as 1. Whole blocks, since rasterisers shade whole blocks or quads anyway.
//   MASK        the level's blurred mask is above zero for a pixel of the block
//   EDGE        there is an edge in the block
//   DIFFERENCE  the coarser level showed in the block or next to it that it differed from what is coarser still
//   BEND        the coarser level, the coarsest, bends: a texel in or next to the block differs from the mean of those around
#include "mres/frame_params.h"
#include "mres/level.glsl"
#include "mres/value.glsl"

uniform sampler2D maskTexture;
uniform sampler2D refineTexture;
uniform sampler2D coarserTexture;

out float fragment;

#if EDGE
bool hasEdge(ivec2 block) {
    ivec2 last = textureSize(maskTexture, 0) - 1;
    vec2 edges = vec2(0.0);
    for (int i = 0; i < 4; ++i)
        edges = max(edges, texelFetch(maskTexture, min(2 * block + ivec2(i & 1, i >> 1), last), 0).rg);
    return max(edges.r, edges.g) > 0.0;
}
#endif

#if BEND
Value coarserAt(ivec2 texel) { return VALUE(texelFetch(coarserTexture, texel, 0)); }

// A level of half the resolution would have shown the mean of the neighbours. The next finer level's pixels lie half as far
// from those of this one: half of what is worth a difference there is worth it here.
bool bendsAt(ivec2 texel) {
    Value value = coarserAt(texel);
    Value alongX = 0.5 * (coarserAt(texel - ivec2(1, 0)) + coarserAt(texel + ivec2(1, 0)));
    Value alongY = 0.5 * (coarserAt(texel - ivec2(0, 1)) + coarserAt(texel + ivec2(0, 1)));
    return max(shownDifference(value, alongX), shownDifference(value, alongY)) > 0.5 * refineThreshold;
}

// At the texels that pixels of the block are interpolated from, but for the border's, which lack a neighbour. Blocks end at
// halves of texels at the least: rounding must not take one for the next.
const float kRounding = 1.0 / 64.0;

bool bends(vec2 low, vec2 high) {
    vec2 texels = vec2(textureSize(coarserTexture, 0));
    ivec2 inside = textureSize(coarserTexture, 0) - 2;
    ivec2 first = clamp(ivec2(floor(low * texels - 0.5 + kRounding)), ivec2(1), inside);
    ivec2 last = clamp(ivec2(floor(high * texels - 0.5 + kRounding)) + 1, ivec2(1), inside);
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            if (bendsAt(ivec2(x, y))) return true;
        }
    }
    return false;
}
#endif

void main() {
    ivec2 block = ivec2(gl_FragCoord.xy);
    vec2 low = vec2(block * ZONE_BLOCK * levelStride);
    vec2 high = low + float(ZONE_BLOCK * levelStride);
    bool renders = false;
#if MASK
    renders = renders || largestAtCorners(maskTexture, low * maskFromPixel, high * maskFromPixel) > 0.0;
#endif
#if EDGE
    renders = renders || hasEdge(block);
#endif
#if DIFFERENCE
    renders = renders || largestAtCorners(refineTexture, low * coarserFromPixel, high * coarserFromPixel) > 0.0;
#endif
#if BEND
    renders = renders || bends(low * coarserFromPixel, high * coarserFromPixel);
#endif
    fragment = renders ? 1.0 : 0.0;
}
