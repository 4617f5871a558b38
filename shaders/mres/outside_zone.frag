#version 330 core
// Outside of a level's zone its picture is the coarser level's, bilinearly upsampled, and its stencil is cleared.
// REFINABLE: a finer level follows, for which there is nothing to refine here.
#include "mres/frame_params.h"
#include "mres/level.glsl"

uniform sampler2D zoneTexture;
uniform sampler2D coarserTexture;

layout(location = 0) out vec4 fragment;
#if REFINABLE
layout(location = 1) out float refine;
#endif

void main() {
    ivec2 levelPixel = ivec2(gl_FragCoord.xy);
    if (texelFetch(zoneTexture, levelPixel / ZONE_BLOCK, 0).r > 0.0) discard;
    ivec2 fullPixel = representativePixel(levelPixel, size);
    fragment = texture(coarserTexture, coarserCoordinate(fullPixel));
#if REFINABLE
    refine = 0.0;
#endif
}
