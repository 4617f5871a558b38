// What a pixel's neighbours say of it: their mean, each counting as far as it lies on the pixel's tangent plane, just as the
// filter trusts its taps (joint bilateral upsampling, Kopf et al. 2007). Where none lies there, the one nearest in depth
// stands in (Jansen and Bavoil 2011, "Fast rendering of opacity-mapped particles using DirectX 11 tessellation and mixed
// resolutions").
#include "mres/tangent_plane.glsl"
#include "mres/value.glsl"

uniform vec4 backgroundValue;

struct Neighbours {
    vec4 texels[4];   // value, then filter depth
    ivec2 pixels[4];  // of the full resolution, at which they were evaluated
    vec4 shares;      // of the mean, if all are trusted
};

// Of the neighbour whose depth is nearest to the pixel's.
Value nearestInDepth(float viewDepth, Neighbours around) {
    Value nearest = VALUE(around.texels[0]);
    float leastStep = abs(viewDepthOfFilter(FILTER_DEPTH(around.texels[0])) - viewDepth);
    for (int i = 1; i < 4; ++i) {
        float depthStep = abs(viewDepthOfFilter(FILTER_DEPTH(around.texels[i])) - viewDepth);
        if (depthStep < leastStep) nearest = VALUE(around.texels[i]);
        leastStep = min(leastStep, depthStep);
    }
    return nearest;
}

// Sums differences to the nearest, so that equal values stay what they are, to the last bit.
Value meanOnPlane(ivec2 fullPixel, float viewDepth, Neighbours around) {
    TangentPlane plane = tangentPlane(fullPixel, viewDepth);
    Value nearest = nearestInDepth(viewDepth, around);
    Value sum = Value(0.0);
    float weightSum = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec4 texel = around.texels[i];
        vec2 pixels = vec2(around.pixels[i] - fullPixel);
        bool background = isBackgroundFilterDepth(FILTER_DEPTH(texel));
        float trust = background ? 0.0 : trustIn(plane, pixels, viewDepthOfFilter(FILTER_DEPTH(texel)));
        sum += (VALUE(texel) - nearest) * (around.shares[i] * trust);
        weightSum += around.shares[i] * trust;
    }
    return weightSum > 0.0 ? nearest + sum / weightSum : nearest;
}

// The texel that a pixel without one gets from its neighbours. What the background's value is, is known.
vec4 texelAmong(Neighbours around, ivec2 fullPixel) {
    float windowDepth = texelFetch(depthTexture, fullPixel, 0).r;
    float viewDepth = viewDepthOf(windowDepth);
    bool background = windowDepth == backgroundDepth;
    vec4 texel = vec4(0.0);
    VALUE(texel) = background ? VALUE(backgroundValue) : meanOnPlane(fullPixel, viewDepth, around);
    FILTER_DEPTH(texel) = background ? kBackgroundFilterDepth : filterDepthOf(viewDepth);
    return texel;
}
