#version 330 core
// View depth at every 2^level-th pixel. Each texel is the depth of one real pixel, whose place is known exactly,
// so that a plane stays a plane at every level.
#include "mres/frame.glsl"

uniform int pyramidLevel;

out float fragment;

// Nothing is behind it, and squares of it are still finite.
const float kBackgroundViewDepth = 1e18;

void main() {
    ivec2 fullPixel = ivec2(gl_FragCoord.xy) * (1 << pyramidLevel) + ((1 << pyramidLevel) >> 1);
    float windowDepth = texelFetch(depthTexture, min(fullPixel, size - 1), 0).r;
    fragment = windowDepth == backgroundDepth ? kBackgroundViewDepth : viewDepthOf(windowDepth);
}
