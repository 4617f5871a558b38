#version 330 core
// Interleaves the phases again. FILTERED: with the first half of the filter on the way, which saves a pass.
#include "mres/filter.glsl"
#include "peers/phases.glsl"

uniform sampler2D levelTexture;  // the phases' tiles

out vec4 fragment;

vec4 levelTexel(ivec2 levelPixel) { return texelFetch(levelTexture, texelOfPixel(levelPixel), 0); }

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    fragment = levelTexel(pixel);
#if FILTERED
    VALUE(fragment) = filterAlong(ivec2(1, 0), pixel, fragment);
#endif
}
