// The depth-aware filter that integrates the effects' repeating patterns exactly: a period, symmetric about the pixel
// (for four pixels 1/8 1/4 1/4 1/4 1/8, for two 1/4 1/2 1/4), one axis a pass, each tap trusted as far as it lies on the
// centre's tangent plane. A tap that was not rendered has filter depth 0 and no weight.
#include "mres/level.glsl"
#include "mres/tangent_plane.glsl"
#include "mres/value.glsl"

// A pixel of this level, wherever its texel lies: mres/level_texel.glsl, or a function of the including shader's own.
vec4 levelTexel(ivec2 levelPixel);

// Off the screen, the pixel of the same phase of the pattern on the other side stands in.
ivec2 tapInside(ivec2 levelPixel) {
    ivec2 last = levelSize - 1;
    ivec2 inside = levelPixel + noisePeriod * (ivec2(lessThan(levelPixel, ivec2(0))) - ivec2(greaterThan(levelPixel, last)));
    return clamp(inside, ivec2(0), last);
}

// Filters along `axis` around a pixel of this level; `centre` is that pixel's texel. Sums differences, so that equal
// values stay what they are, to the last bit.
Value filterAlong(ivec2 axis, ivec2 levelPixel, vec4 centre) {
    float share = 1.0 / float(noisePeriod);
    ivec2 fullPixel = representativePixel(levelPixel, size);
    TangentPlane plane = tangentPlane(fullPixel, viewDepthOfFilter(FILTER_DEPTH(centre)));
    bool background = isBackgroundFilterDepth(FILTER_DEPTH(centre));
    Value value = VALUE(centre);
    Value sum = Value(0.0);
    float weightSum = share;
    int taps = noisePeriod >> 1 << 1;
    for (int i = 0; i < taps; ++i) {
        int distance = 1 + (i >> 1);
        ivec2 tap = tapInside(levelPixel + axis * ((i & 1) == 0 ? distance : -distance));
        vec4 texel = levelTexel(tap);
        vec2 pixels = vec2(representativePixel(tap, size) - fullPixel);
        float trust = trustIn(plane, pixels, viewDepthOfFilter(FILTER_DEPTH(texel)));
        bool rendered = FILTER_DEPTH(texel) > 0.0;
        bool sameKind = isBackgroundFilterDepth(FILTER_DEPTH(texel)) == background;
        float inPeriod = 2 * distance == noisePeriod ? 0.5 : 1.0;
        float weight = rendered && sameKind ? inPeriod * share * trust : 0.0;
        // What was not rendered may be anything, even not a number.
        sum += (weight > 0.0 ? VALUE(texel) - value : Value(0.0)) * weight;
        weightSum += weight;
    }
    return value + sum / weightSum;
}
