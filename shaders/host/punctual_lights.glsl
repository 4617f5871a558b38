// The falloffs of KHR_lights_punctual.
#include "host/light_params.h"

// Inverse square, windowed so that it ends smoothly at the range.
float distanceFalloff(float distanceSquared, float inverseRange) {
    float ratio = distanceSquared * inverseRange * inverseRange;
    float window = clamp(1.0 - ratio * ratio, 0.0, 1.0);
    return window / max(distanceSquared, 1e-4);  // a light's own size keeps a surface at 1 cm from burning out
}

float coneFalloff(float cosine, float scale, float offset) {
    float share = clamp(cosine * scale + offset, 0.0, 1.0);
    return share * share;
}

// Light i at a point: its direction, and what a surface across that direction receives of it.
vec3 illuminance(int i, vec3 position, out vec3 toLight) {
    vec4 place = lightPosition[i];
    vec3 intensity = lightIntensity[i].rgb;
    toLight = -lightDirection[i].xyz;
    if (place.w < 0.0) return intensity;  // directional
    vec3 difference = place.xyz - position;
    float distanceSquared = dot(difference, difference);
    vec3 direction = difference * inversesqrt(max(distanceSquared, 1e-8));
    float cone = coneFalloff(dot(direction, toLight), lightIntensity[i].w, lightDirection[i].w);
    toLight = direction;
    return intensity * distanceFalloff(distanceSquared, place.w) * cone;
}
