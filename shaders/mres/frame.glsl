// The frame's G-buffer as the passes of mres read it.
#include "mres/frame_params.h"

uniform sampler2D depthTexture;   // window depth, full resolution
uniform sampler2D normalTexture;  // full resolution

float viewDepthOf(float windowDepth) {
    return (linearise.x + linearise.y * windowDepth) / (linearise.z + linearise.w * windowDepth);
}

// |d view depth / d window depth| is depthSlope() / slopeRoot(window depth)^2.
float depthSlope() {
    return abs(linearise.y * linearise.z - linearise.x * linearise.w);
}

float slopeRoot(float windowDepth) {
    return abs(linearise.z + linearise.w * windowDepth);
}

float depthRoundingAt(float windowDepth) {
    return depthRounding.x + depthRounding.y * windowDepth;
}

// Metres of view depth by which rounding may move a surface.
float viewDepthRoundingAt(float windowDepth) {
    float root = slopeRoot(windowDepth);
    return depthRoundingAt(windowDepth) * depthSlope() / (root * root);
}

// How a pixel's point moves with a metre of its view depth.
vec3 perViewDepth(vec2 pixel) {
    return vec3(pixel * unprojectScaled.xy + unprojectScaled.zw, -1.0);
}

// View-space position of a point given by its pixel coordinates (centres at + 0.5) and view depth.
vec3 unproject(vec2 pixel, float viewDepth) {
    vec2 xy = viewDepth * (pixel * unprojectScaled.xy + unprojectScaled.zw)
            + (pixel * unprojectConstant.xy + unprojectConstant.zw);
    return vec3(xy, -viewDepth);
}

vec3 viewNormal(ivec2 pixel) {
    vec3 decoded = texelFetch(normalTexture, pixel, 0).xyz * normalDecode.x + normalDecode.y;
    return normalize(mat3(viewFromNormals) * decoded);
}
