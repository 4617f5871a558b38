#version 330 core
// Outside of a level's zone its picture is the coarser level's, bilinearly upsampled, and its stencil is cleared.
// REFINABLE: a finer level follows, for which there is nothing to refine here. DISJOINT: the coarser level rendered nothing
// where this level's zone covers its pixels whole; what is there is no picture.
#include "mres/coarser.glsl"

uniform sampler2D zoneTexture;

layout(location = 0) out vec4 fragment;
#if REFINABLE
layout(location = 1) out float refine;
#endif

#if DISJOINT
#include "mres/disjoint.glsl"

// Bilinear, as far as there is a picture. There is one in the coarser pixel that a pixel outside of the zone lies in, which
// is always one of the four and has weight. Sums differences to it, so that equal values stay what they are.
vec4 coarserPicture(vec2 place) {
    Footprint footprint = footprintAt(place);
    vec4 around = texelFetch(coarserTexture, ivec2(place) / coarserStride, 0);
    vec4 sum = vec4(0.0);
    float weightSum = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 tap = texelOf(footprint, i);
        if (isCovered(zoneTexture, levelStride, tap, coarserStride)) continue;
        sum += (texelFetch(coarserTexture, tap, 0) - around) * footprint.shares[i];
        weightSum += footprint.shares[i];
    }
    return around + sum / weightSum;
}
#else
vec4 coarserPicture(vec2 place) {
    return texture(coarserTexture, coarserCoordinate(place));
}
#endif

void main() {
    ivec2 levelPixel = ivec2(gl_FragCoord.xy);
    if (texelFetch(zoneTexture, levelPixel / ZONE_BLOCK, 0).r > 0.0) discard;
    fragment = coarserPicture(placeOf(levelPixel, size));
#if REFINABLE
    refine = 0.0;
#endif
}
