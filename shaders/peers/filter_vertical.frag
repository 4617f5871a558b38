#version 330 core
// Second half of the filter, along y, keeping the filter depth for who upsamples. FILTERED: whether the effect is filtered;
// else values stay as they are.
#include "mres/filter.glsl"
#include "mres/level_texel.glsl"

out vec4 fragment;

void main() {
    ivec2 levelPixel = ivec2(gl_FragCoord.xy);
    fragment = levelTexel(levelPixel);
#if FILTERED
    VALUE(fragment) = filterAlong(ivec2(0, 1), levelPixel, fragment);
#endif
}
