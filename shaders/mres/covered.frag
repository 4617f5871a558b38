#version 330 core
// Takes from a level's zone what a finer level covers: for the stencil alone.
#include "mres/frame_params.h"
#include "mres/level.glsl"
#include "mres/disjoint.glsl"

uniform sampler2D zoneTexture;  // the finer level's
uniform int finerStride;

void main() {
    if (!isCovered(zoneTexture, finerStride, ivec2(gl_FragCoord.xy), levelStride)) discard;
}
