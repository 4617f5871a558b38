#version 330 core
// The edge image at half resolution: red where normals change (first derivative), green where depth leaves its
// plane (second derivative), both over the 2x2 pixels of this texel and their neighbours.
//
// The second derivative is taken of window depth, which is affine in screen space on every plane (perspective or
// orthographic), so that a plane seen at any angle is exactly zero. It becomes metres between the nearest and the
// farthest surface around.
#include "mres/depth_step.glsl"
#include "mres/normal_step.glsl"

out vec2 fragment;

float depthAt(ivec2 pixel) {
    return texelFetch(depthTexture, pixel, 0).r;
}

float secondDifference(float before, float here, float after) {
    return abs((before - here) + (after - here));
}

// The two second differences of four pixels in a row.
float bend(float a, float b, float c, float d) {
    return max(secondDifference(a, b, c), secondDifference(b, c, d));
}

// Pixels at the border lack a neighbour, and so a second derivative: there the 4x4 pixels are moved inside.
bool hasDepthEdge(ivec2 texelCorner, out bool background) {
    ivec2 corner = clamp(texelCorner, ivec2(1), size - 3);
    float d00 = depthAt(corner), d10 = depthAt(corner + ivec2(1, 0));
    float d01 = depthAt(corner + ivec2(0, 1)), d11 = depthAt(corner + ivec2(1, 1));
    vec4 alongX = vec4(depthAt(corner + ivec2(-1, 0)), depthAt(corner + ivec2(2, 0)),
                       depthAt(corner + ivec2(-1, 1)), depthAt(corner + ivec2(2, 1)));
    vec4 alongY = vec4(depthAt(corner + ivec2(0, -1)), depthAt(corner + ivec2(0, 2)),
                       depthAt(corner + ivec2(1, -1)), depthAt(corner + ivec2(1, 2)));
    float largest = max(max(bend(alongX.x, d00, d10, alongX.y), bend(alongX.z, d01, d11, alongX.w)),
                        max(bend(alongY.x, d00, d01, alongY.y), bend(alongY.z, d10, d11, alongY.w)));
    vec4 inside = vec4(d00, d10, d01, d11);
    vec4 low = min(inside, min(alongX, alongY));
    vec4 high = max(inside, max(alongX, alongY));
    float lowest = min(min(low.x, low.y), min(low.z, low.w));
    float highest = max(max(high.x, high.y), max(high.z, high.w));
    background = lowest == backgroundDepth && highest == backgroundDepth;
    return isDepthStep(largest, lowest, highest);
}

bool hasNormalEdge(ivec2 corner) {
    vec3 n00 = encodedNormal(corner);
    vec3 n10 = encodedNormal(corner + ivec2(1, 0));
    vec3 n01 = encodedNormal(corner + ivec2(0, 1));
    vec3 n11 = encodedNormal(corner + ivec2(1, 1));
    return isNormalStep(n00, n10) || isNormalStep(n01, n11) || isNormalStep(n00, n01) || isNormalStep(n10, n11) ||
           isNormalStep(n10, encodedNormal(corner + ivec2(2, 0))) ||
           isNormalStep(n11, encodedNormal(corner + ivec2(2, 1))) ||
           isNormalStep(n01, encodedNormal(corner + ivec2(0, 2))) ||
           isNormalStep(n11, encodedNormal(corner + ivec2(1, 2))) ||
           isNormalStep(n00, encodedNormal(corner + ivec2(-1, 0))) ||
           isNormalStep(n01, encodedNormal(corner + ivec2(-1, 1))) ||
           isNormalStep(n00, encodedNormal(corner + ivec2(0, -1))) ||
           isNormalStep(n10, encodedNormal(corner + ivec2(1, -1)));
}

void main() {
    ivec2 corner = ivec2(gl_FragCoord.xy) * 2;
    bool background;
    bool depthEdge = hasDepthEdge(corner, background);
    fragment = vec2(!background && hasNormalEdge(corner), depthEdge);  // what the sky has for normals means nothing
}
