#version 330 core
// Second half of the filter (along y), and the blend over the coarser level:
//   c'_i = c_i min(a_i w_i, 1) + c'_(i+1) (1 - min(a_i w_i, 1))        (equation 1; i + 1 is the coarser level)
// FILTERED, COARSEST: whether the effect is filtered, and whether there is a coarser level at all.
#include "mres/filter.glsl"

uniform sampler2D coarserTexture;
uniform sampler2D maskTexture;

out vec4 fragment;

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
    Value coarser = VALUE(texture(coarserTexture, coarserCoordinate(fullPixel)));
    value = value * alpha + coarser * (1.0 - alpha);
#endif
    fragment = vec4(0.0, 0.0, 0.0, 1.0);
    VALUE(fragment) = value;
}
