#version 330 core
// Runs an effect's shade() in the pixels of one level. EFFECT_CHANNELS is 1 or 3.
#include "mres/filter_depth.glsl"
#include "mres/surface.glsl"
#include "effect"

uniform vec4 backgroundValue;

out vec4 fragment;

void main() {
    Surface surface = fetchSurface(ivec2(gl_FragCoord.xy));
    vec4 value = shade(surface);
    float depth = filterDepthOf(surface.depth);
    if (surface.background) {
        value = backgroundValue;
        depth = kBackgroundFilterDepth;
    }
#if EFFECT_CHANNELS == 1
    fragment = vec4(value.r, depth, 0.0, 0.0);
#else
    fragment = vec4(value.rgb, depth);
#endif
}
