#version 330 core
// Runs an effect's shade() in the pixels of the checkerboard, packed.
#include "mres/effect_texel.glsl"
#include "peers/checkerboard.glsl"

out vec4 fragment;

void main() {
    fragment = effectTexel(pixelOfTexel(ivec2(gl_FragCoord.xy)));
}
