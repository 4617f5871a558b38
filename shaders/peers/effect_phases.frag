#version 330 core
// Runs an effect's shade() phase by phase.
#include "mres/effect_texel.glsl"
#include "peers/phases.glsl"

out vec4 fragment;

void main() {
    fragment = effectTexel(pixelOfTexel(ivec2(gl_FragCoord.xy)));
}
