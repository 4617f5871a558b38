#version 330 core
// The zone of a level, one texel a block of 4x4 of its pixels: above zero where the effect renders, for any of the reasons
// that are defined as 1. Whole blocks, since rasterisers shade whole blocks or quads anyway.
//   MASK        the level's blurred mask is above zero for a pixel of the block
//   EDGE        there is an edge in the block
//   SHOWN_EDGE  there is a step of depth in the block, or of normals, and the coarser level's picture varies around it or lacks
//               what is seen there: where surfaces meet that look alike, there is nothing to refine
//   DIFFERENCE  the coarser level showed in the block or next to it that it differed from what is coarser still
//   BEND        the coarser level, the coarsest, bends: a texel in or next to the block differs from the mean of those around
#include "mres/frame_params.h"
#include "mres/level.glsl"
#include "mres/value.glsl"

uniform sampler2D maskTexture;
uniform sampler2D refineTexture;
uniform sampler2D coarserTexture;

out float fragment;

#if EDGE || SHOWN_EDGE
vec2 edgesIn(ivec2 block) {
    ivec2 last = textureSize(maskTexture, 0) - 1;
    vec2 edges = vec2(0.0);
    for (int i = 0; i < 4; ++i)
        edges = max(edges, texelFetch(maskTexture, min(2 * block + ivec2(i & 1, i >> 1), last), 0).rg);
    return edges;
}
#endif

#if SHOWN_EDGE || BEND
Value coarserAt(ivec2 texel) { return VALUE(texelFetch(coarserTexture, texel, 0)); }

// The texels that pixels of the block are interpolated from. Blocks end at halves of texels at the least: rounding must not
// take one for the next.
const float kRounding = 1.0 / 64.0;

ivec2 firstTexel(vec2 low) { return ivec2(floor(low * vec2(textureSize(coarserTexture, 0)) - 0.5 + kRounding)); }
ivec2 lastTexel(vec2 high) { return firstTexel(high) + 1; }
#endif

#if SHOWN_EDGE
#include "mres/normal_step.glsl"

// By half of what is worth a difference: pixels of the block may lie as far again from what the texels show.
bool varies(vec2 low, vec2 high) {
    ivec2 border = textureSize(coarserTexture, 0) - 1;
    ivec2 first = clamp(firstTexel(low), ivec2(0), border), last = clamp(lastTexel(high), ivec2(0), border);
    Value least = coarserAt(first), most = least;
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            Value value = coarserAt(ivec2(x, y));
            least = min(least, value);
            most = max(most, value);
        }
    }
    return shownDifference(least, most) > 0.5 * refineThreshold;
}

// Whether a pixel of the level faces as none of the texels does that it is interpolated from: they missed what is seen there.
bool isMisfit(ivec2 levelPixel) {
    vec3 normal = encodedNormal(representativePixel(levelPixel, size));
    ivec2 first = firstTexel(coarserCoordinate(placeOf(levelPixel, size)));
    ivec2 border = textureSize(coarserTexture, 0) - 1;
    bool fits = false;
    for (int i = 0; i < 4; ++i) {
        ivec2 texel = clamp(first + ivec2(i & 1, i >> 1), ivec2(0), border);
        fits = fits || !isNormalStep(normal, encodedNormal(coarserRepresentativePixel(texel, size)));
    }
    return !fits;
}

bool hasShownEdge(ivec2 block, vec2 low, vec2 high) {
    vec2 edges = edgesIn(block);
    bool shown = edges.g > 0.0 || (edges.r > 0.0 && varies(low, high));
    // Rasterisers that take both ways of every branch leave out loops of nothing.
    int pixels = shown || edges.r == 0.0 ? 0 : ZONE_BLOCK * ZONE_BLOCK;
    bool misses = false;
    for (int i = 0; i < pixels; ++i) {
        ivec2 levelPixel = block * ZONE_BLOCK + ivec2(i % ZONE_BLOCK, i / ZONE_BLOCK);
        misses = misses || isMisfit(min(levelPixel, levelSize - 1));
    }
    return shown || misses;
}
#endif

#if BEND
// A level of half the resolution would have shown the mean of the neighbours. The next finer level's pixels lie half as far
// from those of this one: half of what is worth a difference there is worth it here.
bool bendsAt(ivec2 texel) {
    Value value = coarserAt(texel);
    Value alongX = 0.5 * (coarserAt(texel - ivec2(1, 0)) + coarserAt(texel + ivec2(1, 0)));
    Value alongY = 0.5 * (coarserAt(texel - ivec2(0, 1)) + coarserAt(texel + ivec2(0, 1)));
    return max(shownDifference(value, alongX), shownDifference(value, alongY)) > 0.5 * refineThreshold;
}

// The border's texels lack a neighbour.
bool bends(vec2 low, vec2 high) {
    ivec2 inside = textureSize(coarserTexture, 0) - 2;
    ivec2 first = clamp(firstTexel(low), ivec2(1), inside), last = clamp(lastTexel(high), ivec2(1), inside);
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
    renders = renders || any(greaterThan(edgesIn(block), vec2(0.0)));
#endif
#if SHOWN_EDGE
    renders = renders || hasShownEdge(block, low * coarserFromPixel, high * coarserFromPixel);
#endif
#if DIFFERENCE
    renders = renders || largestAtCorners(refineTexture, low * coarserFromPixel, high * coarserFromPixel) > 0.0;
#endif
#if BEND
    renders = renders || bends(low * coarserFromPixel, high * coarserFromPixel);
#endif
    fragment = renders ? 1.0 : 0.0;
}
