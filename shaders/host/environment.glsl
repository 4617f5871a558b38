// The sky and the ambient light.
#include "host/environment_params.h"

// Radiance of the sky in a direction: a gradient that is steepest near the horizon, as haze makes it.
vec3 skyRadiance(vec3 direction) {
    vec3 above = mix(skyHorizon.rgb, skyZenith.rgb, sqrt(max(direction.y, 0.0)));
    return mix(above, skyGround.rgb, smoothstep(0.0, 0.1, -direction.y));
}

// Ambient radiance that comes from a direction: linear in its height.
vec3 ambientRadiance(vec3 direction) {
    return mix(ambientBelow.rgb, ambientAbove.rgb, direction.y * 0.5 + 0.5);
}

// Irradiance / pi of it where nothing hides any, the mean of the radiance over the cosine-weighted hemisphere around the
// normal. What is linear in the direction has the mean that it has in the mean direction: that is the normal times the
// mean cosine, the integral of 2 c * c dc over 0..1, which is 2/3. So it is mix(below, above, 0.5 + normal.y / 3).
vec3 diffuseAmbient(vec3 normal) {
    return ambientRadiance(normal * (2.0 / 3.0));
}
