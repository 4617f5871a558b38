#version 330 core
// First half of the filter: along x, keeping the filter depth for the second.
#include "mres/filter.glsl"
#include "mres/level_texel.glsl"

out vec4 fragment;

void main() {
    ivec2 levelPixel = ivec2(gl_FragCoord.xy);
    fragment = levelTexel(levelPixel);
    VALUE(fragment) = filterAlong(ivec2(1, 0), levelPixel, fragment);
}
