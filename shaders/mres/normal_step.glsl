// What counts as a step of normals: an angle wider than the threshold.
#include "mres/edges_params.h"
#include "mres/frame.glsl"

// As it is encoded: differences of it are differences of normals but for a factor.
vec3 encodedNormal(ivec2 pixel) {
    return texelFetch(normalTexture, clamp(pixel, ivec2(0), size - 1), 0).xyz;
}

bool isNormalStep(vec3 a, vec3 b) {
    vec3 difference = a - b;
    return dot(difference, difference) > normalDifference2;
}
