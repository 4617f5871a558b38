// What an effect's shade() has at a pixel of a level, as the level's textures hold it: value, then filter depth.
// EFFECT_CHANNELS is 1 or 3.
#include "mres/filter_depth.glsl"
#include "mres/surface.glsl"
#include "effect"

uniform vec4 backgroundValue;

// A single NaN or infinity would spread through the filter and to every finer level.
bool isUsable(vec4 value) {
#if EFFECT_CHANNELS == 1
    return !isnan(value.r) && !isinf(value.r);
#else
    return !any(isnan(value.rgb)) && !any(isinf(value.rgb));
#endif
}

vec4 effectTexel(ivec2 levelPixel) {
    Surface surface = fetchSurface(levelPixel);
    vec4 value = shade(surface);
    if (surface.background || !isUsable(value)) value = backgroundValue;
    value = clamp(value, -kLargestHalf, kLargestHalf);
    float depth = surface.background ? kBackgroundFilterDepth : filterDepthOf(surface.depth);
#if EFFECT_CHANNELS == 1
    return vec4(value.r, depth, 0.0, 0.0);
#else
    return vec4(value.rgb, depth);
#endif
}
