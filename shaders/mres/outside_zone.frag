#version 330 core
// Outside of a level's zone its picture is the coarser level's, bilinearly upsampled, and its stencil is cleared.
// REFINABLE: a finer level follows, for which there is nothing to refine here. DISJOINT: the coarser level rendered nothing
// where this level's zone covers its pixels whole; what is there is no picture.
#include "mres/frame_params.h"
#include "mres/level.glsl"

uniform sampler2D zoneTexture;
uniform sampler2D coarserTexture;

layout(location = 0) out vec4 fragment;
#if REFINABLE
layout(location = 1) out float refine;
#endif

#if DISJOINT
#include "mres/disjoint.glsl"

uniform int coarserStride;

// Bilinear, as far as there is a picture. There is one in the coarser pixel that a pixel outside of the zone lies in, which
// is always one of the four and has weight. Sums differences to it, so that equal values stay what they are.
vec4 coarserPicture(vec2 place) {
    ivec2 last = textureSize(coarserTexture, 0) - 1;
    vec2 texel = coarserCoordinate(place) * vec2(last + 1) - 0.5;
    ivec2 corner = ivec2(floor(texel));
    vec2 share = texel - vec2(corner);
    vec4 around = texelFetch(coarserTexture, ivec2(place) / coarserStride, 0);
    vec4 sum = vec4(0.0);
    float weightSum = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 offset = ivec2(i & 1, i >> 1);
        ivec2 tap = clamp(corner + offset, ivec2(0), last);
        if (isCovered(zoneTexture, levelStride, tap, coarserStride)) continue;
        vec2 shares = mix(1.0 - share, share, vec2(offset));
        sum += (texelFetch(coarserTexture, tap, 0) - around) * (shares.x * shares.y);
        weightSum += shares.x * shares.y;
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
