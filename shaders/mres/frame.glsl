// The frame's G-buffer as the passes of mres read it.
#include "mres/frame_params.h"

uniform sampler2D depthTexture;   // window depth, full resolution
uniform sampler2D normalTexture;  // full resolution

float viewDepthOf(float windowDepth) {
    return (linearise.x + linearise.y * windowDepth) / (linearise.z + linearise.w * windowDepth);
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
