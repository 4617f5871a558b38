#version 330 core
// The edge image at half resolution: red where normals change (first derivative), green where depth leaves its
// plane (second derivative), both over the 2x2 pixels of this texel and their neighbours.
//
// The second derivative is taken of window depth, which is affine in screen space on every plane (perspective or
// orthographic), so that a plane seen at any angle is exactly zero. Multiplied by the slope of view depth over
// window depth it becomes metres; the smallest slope of the three pixels is the one of the surface in front.
#include "mres/frame.glsl"
#include "mres/edges_params.h"

out vec2 fragment;

float depthAt(ivec2 pixel) {
    return texelFetch(depthTexture, clamp(pixel, ivec2(0), size - 1), 0).r;
}

vec3 normalAt(ivec2 pixel) {
    return texelFetch(normalTexture, min(pixel, size - 1), 0).xyz * normalDecode.x + normalDecode.y;
}

float metresPerWindowDepth(float windowDepth) {
    float denominator = depthSlope.y + depthSlope.z * windowDepth;
    return depthSlope.x / (denominator * denominator);
}

bool isDepthEdge(float before, float here, float after) {
    float secondDifference = abs((before - here) + (after - here));
    if (secondDifference <= depthRounding.x + depthRounding.y * here) return false;
    float slope = min(metresPerWindowDepth(here), min(metresPerWindowDepth(before), metresPerWindowDepth(after)));
    return secondDifference * slope > depthThreshold;
}

// Background has no normal (length zero): its borders are depth edges.
bool isNormalEdge(vec3 a, vec3 b) {
    float lengths = dot(a, a) * dot(b, b);
    return lengths > 0.25 && dot(a, b) < normalCosine * sqrt(lengths);
}

bool hasDepthEdge(ivec2 corner) {
    float centre[4] = float[4](depthAt(corner), depthAt(corner + ivec2(1, 0)), depthAt(corner + ivec2(0, 1)),
                               depthAt(corner + ivec2(1, 1)));
    for (int i = 0; i < 2; ++i) {
        float left = depthAt(corner + ivec2(-1, i));
        float right = depthAt(corner + ivec2(2, i));
        float below = depthAt(corner + ivec2(i, -1));
        float above = depthAt(corner + ivec2(i, 2));
        if (isDepthEdge(left, centre[2 * i], centre[2 * i + 1])) return true;
        if (isDepthEdge(centre[2 * i], centre[2 * i + 1], right)) return true;
        if (isDepthEdge(below, centre[i], centre[i + 2])) return true;
        if (isDepthEdge(centre[i], centre[i + 2], above)) return true;
    }
    return false;
}

bool hasNormalEdge(ivec2 corner) {
    vec3 n00 = normalAt(corner);
    vec3 n10 = normalAt(corner + ivec2(1, 0));
    vec3 n01 = normalAt(corner + ivec2(0, 1));
    vec3 n11 = normalAt(corner + ivec2(1, 1));
    return isNormalEdge(n00, n10) || isNormalEdge(n01, n11) || isNormalEdge(n00, n01) || isNormalEdge(n10, n11) ||
           isNormalEdge(n10, normalAt(corner + ivec2(2, 0))) || isNormalEdge(n11, normalAt(corner + ivec2(2, 1))) ||
           isNormalEdge(n01, normalAt(corner + ivec2(0, 2))) || isNormalEdge(n11, normalAt(corner + ivec2(1, 2)));
}

void main() {
    ivec2 corner = ivec2(gl_FragCoord.xy) * 2;
    fragment = vec2(hasNormalEdge(corner), hasDepthEdge(corner));
}
