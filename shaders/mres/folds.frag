#version 330 core
// Where normals turn from one pixel of the next coarser level to the next, though from one pixel of the full resolution to
// the next they may not: folds, which are smooth but too narrow for that level. At the resolution of the level's mask.
#include "mres/normal_step.glsl"

uniform int texelStride;    // full-resolution pixels per texel of the mask
uniform int coarserStride;  // and per pixel of the next coarser level

out float fragment;

bool isSurface(ivec2 pixel) {
    return texelFetch(depthTexture, pixel, 0).r != backgroundDepth;
}

bool turnsTowards(ivec2 pixel, ivec2 neighbour) {
    neighbour = clamp(neighbour, ivec2(0), size - 1);
    return isNormalStep(encodedNormal(pixel), encodedNormal(neighbour)) && isSurface(neighbour);
}

void main() {
    ivec2 pixel = min(ivec2(gl_FragCoord.xy) * texelStride + (texelStride >> 1), size - 1);
    ivec2 alongX = ivec2(coarserStride, 0), alongY = ivec2(0, coarserStride);
    bool turns = turnsTowards(pixel, pixel + alongX) || turnsTowards(pixel, pixel - alongX) ||
                 turnsTowards(pixel, pixel + alongY) || turnsTowards(pixel, pixel - alongY);
    fragment = float(turns && isSurface(pixel));
}
