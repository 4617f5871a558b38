// The depth-aware filter that integrates the effects' repeating patterns exactly: a period, symmetric about the pixel
// (for four pixels 1/8 1/4 1/4 1/4 1/8, for two 1/4 1/2 1/4), one axis a pass, each tap trusted as far as it lies on the
// centre's tangent plane. A tap that was not rendered has filter depth 0 and no weight.
#include "mres/filter_depth.glsl"
#include "mres/frame.glsl"
#include "mres/level.glsl"
#include "mres/value.glsl"

uniform sampler2D levelTexture;  // value, then filter depth

#if EFFECT_CHANNELS == 1
#define FILTER_DEPTH(texel) texel.g
#else
#define FILTER_DEPTH(texel) texel.a
#endif

// A pixel's tangent plane. How far the point of another pixel lies along the plane's normal is linear in the pixel and in
// the point's depth: depth * (scaled + dot(pixels, scaledStep)) + constant + dot(pixels, constantStep).
struct TangentPlane {
    float scaled;
    vec2 scaledStep;
    float constant;     // zero for perspective cameras, as is the next
    vec2 constantStep;
    float offset;       // of the plane itself
    float inverseTolerance;
};

TangentPlane tangentPlane(ivec2 fullPixel, float viewDepth) {
    vec3 normal = viewNormal(fullPixel);
    vec2 pixel = vec2(fullPixel) + 0.5;
    TangentPlane plane;
    plane.scaled = dot(normal.xy, pixel * unprojectScaled.xy + unprojectScaled.zw) - normal.z;
    plane.scaledStep = normal.xy * unprojectScaled.xy;
    plane.constant = dot(normal.xy, pixel * unprojectConstant.xy + unprojectConstant.zw);
    plane.constantStep = normal.xy * unprojectConstant.xy;
    plane.offset = viewDepth * plane.scaled + plane.constant;
    plane.inverseTolerance = 1.0 / filterToleranceAt(viewDepth);
    return plane;
}

// 0..1: whole up to the tolerance, none from twice the tolerance on, nor where there is no plane (NaN).
float trustIn(TangentPlane plane, vec2 pixels, float viewDepth) {
    float along = viewDepth * (plane.scaled + dot(pixels, plane.scaledStep)) +
                  (plane.constant + dot(pixels, plane.constantStep));
    float tolerances = abs(along - plane.offset) * plane.inverseTolerance;
    return tolerances < 2.0 ? min(2.0 - tolerances, 1.0) : 0.0;
}

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
        vec4 texel = texelFetch(levelTexture, tap, 0);
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
