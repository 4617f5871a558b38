// From the screen back into the world.
#include "host/view_params.h"

// Camera-relative position of a window coordinate in 0..1 and its window depth.
vec3 positionAt(vec2 uv, float depth) {
    vec4 world = clipToWorld * vec4(vec3(uv, depth) * 2.0 - 1.0, 1.0);
    return world.xyz / world.w;
}

vec3 directionToViewer(vec3 position) { return normalize(eye.xyz - eye.w * position); }
