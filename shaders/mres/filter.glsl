// The depth-aware filter that integrates the effects' repeating 4x4 patterns exactly: five taps weighted
// 1/8 1/4 1/4 1/4 1/8 (a period of four, symmetric about the pixel), one axis a pass, each tap trusted as far as
// it lies on the centre's tangent plane. A tap that was not rendered has filter depth 0 and no weight.
#include "mres/frame.glsl"
#include "mres/level.glsl"

uniform sampler2D levelTexture;  // value, then filter depth

#if EFFECT_CHANNELS == 1
#define Value float
#define VALUE(texel) texel.r
#define FILTER_DEPTH(texel) texel.g
#else
#define Value vec3
#define VALUE(texel) texel.rgb
#define FILTER_DEPTH(texel) texel.a
#endif

vec3 filterPosition(ivec2 levelPixel, float filterDepth) {
    vec2 pixel = vec2(representativePixel(levelPixel, size)) + 0.5;
    return unproject(pixel, filterDepth / filterDepthScale);
}

void addTap(ivec2 levelPixel, float kernelWeight, vec3 planeNormal, float planeOffset, float tolerance,
            Value centre, inout Value sum, inout float weightSum) {
    ivec2 inside = clamp(levelPixel, ivec2(0), levelSize - 1);
    vec4 texel = texelFetch(levelTexture, inside, 0);
    float offPlane = abs(dot(planeNormal, filterPosition(inside, FILTER_DEPTH(texel))) - planeOffset);
    // Written so that a NaN (no normal, no surface) ends in no weight.
    if (FILTER_DEPTH(texel) <= 0.0 || !(offPlane < 2.0 * tolerance)) return;
    float trust = min(2.0 - offPlane / tolerance, 1.0);
    sum += (VALUE(texel) - centre) * (kernelWeight * trust);
    weightSum += kernelWeight * trust;
}

// Filters along `axis` around a pixel of this level; `centre` is that pixel's texel. Sums differences, so that equal
// values stay what they are, to the last bit.
Value filterAlong(ivec2 axis, ivec2 levelPixel, vec4 centre) {
    vec3 normal = viewNormal(representativePixel(levelPixel, size));
    vec3 position = filterPosition(levelPixel, FILTER_DEPTH(centre));
    float planeOffset = dot(normal, position);
    float tolerance = filterTolerance * -position.z;
    Value value = VALUE(centre);
    Value sum = Value(0.0);
    float weightSum = 0.25;
    addTap(levelPixel - 2 * axis, 0.125, normal, planeOffset, tolerance, value, sum, weightSum);
    addTap(levelPixel - axis, 0.25, normal, planeOffset, tolerance, value, sum, weightSum);
    addTap(levelPixel + axis, 0.25, normal, planeOffset, tolerance, value, sum, weightSum);
    addTap(levelPixel + 2 * axis, 0.125, normal, planeOffset, tolerance, value, sum, weightSum);
    return value + sum / weightSum;
}
