// The sky and the ambient light.
#include "host/environment_params.h"

// Radiance of the sky in a direction: a gradient that is steepest near the horizon, as haze makes it.
vec3 skyRadiance(vec3 direction) {
    vec3 above = mix(skyHorizon.rgb, skyZenith.rgb, sqrt(max(direction.y, 0.0)));
    return mix(above, skyGround.rgb, smoothstep(0.0, 0.1, -direction.y));
}

// Ambient radiance that a surface with this normal receives: two hemispheres, blended over the vertical direction.
vec3 ambientRadiance(vec3 normal) {
    return mix(ambientBelow.rgb, ambientAbove.rgb, normal.y * 0.5 + 0.5);
}
