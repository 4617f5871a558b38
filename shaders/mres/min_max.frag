#version 330 core
// Makes one level of the min/max mips. LOWEST: from the frame, 2x2 pixels and the next ones to the right and above, so that
// no two neighbours fall between two blocks; else from the level below.
#include "mres/frame.glsl"
#include "mres/min_max.glsl"

layout(location = 0) out vec2 depthRange;
layout(location = 1) out vec4 leastNormal;
layout(location = 2) out vec4 largestNormal;

#if LOWEST
const int kReach = 3;

Range rangeAt(ivec2 pixel) {
    ivec2 inside = min(pixel, size - 1);
    Range range = emptyRange();
    range.depth = texelFetch(depthTexture, inside, 0).rr;
    if (range.depth.x != backgroundDepth) {
        range.leastNormal = range.largestNormal = texelFetch(normalTexture, inside, 0).xyz;
    }
    return range;
}
#else
const int kReach = 2;

Range rangeAt(ivec2 texel) {
    return fetchRange(texel);
}
#endif

void main() {
    ivec2 corner = ivec2(gl_FragCoord.xy) * 2;
    Range range = emptyRange();
    for (int i = 0; i < kReach * kReach; ++i) range = join(range, rangeAt(corner + ivec2(i % kReach, i / kReach)));
    depthRange = range.depth;
    leastNormal = vec4(range.leastNormal, 0.0);
    largestNormal = vec4(range.largestNormal, 0.0);
}
