#version 330 core
// Runs an effect's shade() in the pixels of one level.
#include "mres/effect_texel.glsl"

out vec4 fragment;

void main() {
    fragment = effectTexel(ivec2(gl_FragCoord.xy));
}
