#version 330 core
// An effect's preview(), the least and the largest value that it may have, at the pixels of the half level.
#include "mres/surface.glsl"
#include "effect"

out vec2 fragment;

void main() {
    fragment = clamp(preview(fetchSurface(ivec2(gl_FragCoord.xy))), 0.0, 1.0);
}
