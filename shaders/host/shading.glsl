// Radiance that a surface sends to the viewer.
#include "host/brdf.glsl"
#include "host/environment.glsl"
#include "host/punctual_lights.glsl"
#include "host/sun_shadow.glsl"

struct ShadingPoint {
    vec3 position;
    vec3 toViewer;
    vec3 albedo;
    vec3 normal;
    vec3 geometricNormal;
    float roughness;
    float metallic;
    float sunVisibility;  // 0..1, or kLookUpShadow
    vec3 indirect;        // irradiance / pi by everything but the lights
};

const float kLookUpShadow = -1.0;

vec3 sunLight(ShadingPoint p, Reflection reflection) {
    if (sunIlluminance.rgb == vec3(0.0) || dot(p.geometricNormal, directionToSun.xyz) <= 0.0) return vec3(0.0);
    vec3 share = reflectedShare(reflection, p.normal, p.toViewer, directionToSun.xyz);
    if (share == vec3(0.0)) return vec3(0.0);
    float visibility = p.sunVisibility == kLookUpShadow ? sunVisibility(p.position, p.geometricNormal) : p.sunVisibility;
    return share * sunIlluminance.rgb * visibility;
}

vec3 punctualLight(ShadingPoint p, Reflection reflection) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < lightCount; ++i) {
        vec3 toLight;
        vec3 received = illuminance(i, p.position, toLight);
        if (received == vec3(0.0)) continue;
        sum += received * reflectedShare(reflection, p.normal, p.toViewer, toLight);
    }
    return sum;
}

// Light from everywhere: reflected diffusely, and in highlights from where the mirror direction looks.
vec3 ambientLight(ShadingPoint p, Reflection reflection, float accessibility) {
    vec3 mirrorDirection = normalize(mix(reflect(-p.toViewer, p.normal), p.normal, p.roughness * p.roughness));
    return reflection.diffuse * p.indirect + reflection.mirrored * ambientRadiance(mirrorDirection) * accessibility;
}

vec3 shade(ShadingPoint p, vec3 emissive, float accessibility) {
    Reflection reflection = reflectionOf(p.albedo, p.metallic, p.roughness, dot(p.normal, p.toViewer));
    return emissive + ambientLight(p, reflection, accessibility) + sunLight(p, reflection) +
           punctualLight(p, reflection);
}
