#version 330 core
// Where normals turn from one pixel of the next coarser level to the next, though from one pixel of the full resolution to
// the next they may not: folds, which are smooth but too narrow for that level. At the resolution of the level's mask, a
// texel of which is a pixel of the next coarser level.
#include "mres/level_params.h"
#include "mres/normal_step.glsl"

out float fragment;

bool isSurface(ivec2 pixel) {
    return texelFetch(depthTexture, pixel, 0).r != backgroundDepth;
}

bool turnsTowards(ivec2 pixel, ivec2 neighbour) {
    neighbour = clamp(neighbour, ivec2(0), size - 1);
    return isNormalStep(encodedNormal(pixel), encodedNormal(neighbour)) && isSurface(neighbour);
}

void main() {
    int stride = 2 * levelStride;
    ivec2 pixel = min(ivec2(gl_FragCoord.xy) * stride + levelStride, size - 1);
    ivec2 alongX = ivec2(stride, 0), alongY = ivec2(0, stride);
    bool turns = turnsTowards(pixel, pixel + alongX) || turnsTowards(pixel, pixel - alongX) ||
                 turnsTowards(pixel, pixel + alongY) || turnsTowards(pixel, pixel - alongY);
    fragment = float(turns && isSurface(pixel));
}
