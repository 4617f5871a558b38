#version 330 core
// Runs an effect's shade() in the pixels of one level. EFFECT_CHANNELS is 1 or 3.
#include "mres/surface.glsl"
#include "effect"

uniform vec4 backgroundValue;

out vec4 fragment;

// The largest half float: farther than every surface, so that the filter never mixes sky and surface.
const float kBackgroundFilterDepth = 65504.0;

void main() {
    Surface surface = fetchSurface(ivec2(gl_FragCoord.xy));
    vec4 value = shade(surface);
    float filterDepth = min(surface.depth * filterDepthScale, 0.5 * kBackgroundFilterDepth);
    if (surface.background) {
        value = backgroundValue;
        filterDepth = kBackgroundFilterDepth;
    }
#if EFFECT_CHANNELS == 1
    fragment = vec4(value.r, filterDepth, 0.0, 0.0);
#else
    fragment = vec4(value.rgb, filterDepth);
#endif
}
