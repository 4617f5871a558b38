#version 330 core
// Second half of the filter (along y), and the blend over the coarser level:
//   c'_i = c_i min(a_i w_i, 1) + c'_(i+1) (1 - min(a_i w_i, 1))        (equation 1; i + 1 is the coarser level)
// A zone that ends where refining did not pay, and not where its mask does, fades over the last half of its blocks.
// FILTERED: whether the effect is filtered. COARSEST: there is no coarser level. REFINABLE: a finer level follows and wants
// to know where this one changed the picture.
#include "mres/filter.glsl"

uniform sampler2D coarserTexture;
uniform sampler2D maskTexture;
uniform sampler2D zoneTexture;

layout(location = 0) out vec4 fragment;
#if REFINABLE
layout(location = 1) out float refine;

#if EFFECT_CHANNELS == 1
float shownDifference(float value, float coarser) { return abs(value - coarser); }
#else
const float kDarkestRadiance = 0.05;

float largest(vec3 v) { return max(v.r, max(v.g, v.b)); }

// Michelson's contrast: of radiances the eye sees the ratio; in the dark there is little to see.
float shownDifference(vec3 value, vec3 coarser) {
    return largest(abs(value - coarser)) / max(largest(value + coarser), 2.0 * kDarkestRadiance);
}
#endif
#endif

void main() {
    ivec2 levelPixel = ivec2(gl_FragCoord.xy);
    vec4 texel = texelFetch(levelTexture, levelPixel, 0);
#if FILTERED
    Value value = filterAlong(ivec2(0, 1), levelPixel, texel);
#else
    Value value = VALUE(texel);
#endif
#if !COARSEST
    ivec2 fullPixel = representativePixel(levelPixel, size);
    float alpha = min(texture(maskTexture, maskCoordinate(fullPixel)).r * blendWeight, 1.0);
    alpha *= max(1.0 - zoneFade * (1.0 - texture(zoneTexture, zoneCoordinate(levelPixel)).r), 0.0);
    Value coarser = VALUE(texture(coarserTexture, coarserCoordinate(fullPixel)));
#if REFINABLE
    refine = shownDifference(value, coarser) > refineThreshold ? 1.0 : 0.0;
#endif
    // So written that neither equal values nor a full weight round.
    if (alpha < 1.0) value = coarser + (value - coarser) * alpha;
#endif
    fragment = vec4(0.0, 0.0, 0.0, 1.0);
    VALUE(fragment) = value;
}
