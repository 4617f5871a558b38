#version 330 core
// Outside of a level's zone its picture is the coarser level's, bilinearly upsampled.
#include "mres/frame_params.h"
#include "mres/level.glsl"

uniform sampler2D coarserTexture;

layout(location = 0) out vec4 fragment;
#if REFINABLE
layout(location = 1) out float refine;
#endif

void main() {
    ivec2 fullPixel = representativePixel(ivec2(gl_FragCoord.xy), size);
    fragment = texture(coarserTexture, coarserCoordinate(fullPixel));
#if REFINABLE
    refine = 0.0;
#endif
}
