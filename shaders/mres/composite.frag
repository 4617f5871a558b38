#version 330 core
// Second half of the filter (along y), and the blend over the coarser level:
//   c'_i = c_i alpha + c'_(i+1) (1 - alpha)        (i + 1 is the coarser level)
// MASKED: alpha is min(a_i w_i, 1), a_i the blurred mask (equation 1). Otherwise the zone fades to a half over the last half
// of its outermost blocks. FILTERED: whether the effect is filtered. COARSEST: there is no coarser level. REFINABLE: a finer level
// follows and wants to know where this one changed the picture.
#include "mres/filter.glsl"
#include "mres/level_texel.glsl"

uniform sampler2D coarserTexture;
uniform sampler2D maskTexture;
uniform sampler2D zoneTexture;

layout(location = 0) out vec4 fragment;
#if REFINABLE
layout(location = 1) out float refine;
#endif

void main() {
    ivec2 levelPixel = ivec2(gl_FragCoord.xy);
    vec4 texel = levelTexel(levelPixel);
#if FILTERED
    Value value = filterAlong(ivec2(0, 1), levelPixel, texel);
#else
    Value value = VALUE(texel);
#endif
#if !COARSEST
    vec2 place = placeOf(levelPixel, size);
#if MASKED
    float alpha = min(texture(maskTexture, maskCoordinate(place)).r * blendWeight, 1.0);
#else
    float alpha = texture(zoneTexture, zoneCoordinate(levelPixel)).r;
#endif
    Value coarser = VALUE(texture(coarserTexture, coarserCoordinate(place)));
#if REFINABLE
    refine = shownDifference(value, coarser) > refineThreshold ? 1.0 : 0.0;
#endif
    // So written that neither equal values nor a full weight round.
    if (alpha < 1.0) value = coarser + (value - coarser) * alpha;
#endif
    fragment = vec4(0.0, 0.0, 0.0, 1.0);
    VALUE(fragment) = value;
}
