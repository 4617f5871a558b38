#version 330 core
// Where the min/max mips say that a pixel of the coarser level is too large: red where the box around its block's normals is
// wider than the threshold, green where its depths are further apart. The range of depth is that of the surface itself, no
// distance off a plane: planes at grazing angles are split, too.
#include "mres/depth_step.glsl"
#include "mres/min_max.glsl"

uniform int ratio;  // texels per texel of the mips, along one axis

out vec2 fragment;

void main() {
    Range range = fetchRange(ivec2(gl_FragCoord.xy) / ratio);
    vec3 normals = max(range.largestNormal - range.leastNormal, 0.0);
    fragment = vec2(dot(normals, normals) > normalDifference2,
                    isDepthStep(range.depth.y - range.depth.x, range.depth.x, range.depth.y));
}
