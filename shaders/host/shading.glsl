// Radiance that a surface sends to the viewer.
#include "host/brdf.glsl"
#include "host/environment.glsl"
#include "host/punctual_lights.glsl"
#include "host/shadow_lookup.glsl"

struct ShadingPoint {
    vec3 position;
    vec3 toViewer;
    vec3 albedo;
    vec3 normal;
    vec3 geometricNormal;
    float roughness;
    float metallic;
    float visibility;     // of the light that casts shadows, 0..1, or kLookUpShadow
    vec3 indirect;        // irradiance / pi by everything but the lights
    float accessibility;  // 0..1, of the ambient light that highlights mirror
};

const float kLookUpShadow = -1.0;

// Of the light that casts shadows: none behind a surface's back, whatever a normal map says.
float visibilityOf(ShadingPoint p, vec3 toLight) {
    if (dot(p.geometricNormal, toLight) <= 0.0) return 0.0;
    return p.visibility == kLookUpShadow ? shadowMapVisibility(p.position, p.geometricNormal, toLight) : p.visibility;
}

vec3 directLight(ShadingPoint p, Reflection reflection) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < lightCount; ++i) {
        vec3 toLight;
        vec3 received = illuminance(i, p.position, toLight);
        if (received == vec3(0.0)) continue;
        vec3 reflected = received * reflectedShare(reflection, p.normal, p.toViewer, toLight);
        if (reflected == vec3(0.0)) continue;
        sum += i < shadowedLights ? reflected * visibilityOf(p, toLight) : reflected;
    }
    return sum;
}

// Light from everywhere: reflected diffusely, and in highlights from where the mirror direction looks.
vec3 ambientLight(ShadingPoint p, Reflection reflection) {
    vec3 mirrorDirection = normalize(mix(reflect(-p.toViewer, p.normal), p.normal, p.roughness * p.roughness));
    return reflection.diffuse * p.indirect + reflection.mirrored * ambientRadiance(mirrorDirection) * p.accessibility;
}

vec3 shade(ShadingPoint p, vec3 emissive) {
    Reflection reflection = reflectionOf(p.albedo, p.metallic, p.roughness, dot(p.normal, p.toViewer));
    return emissive + ambientLight(p, reflection) + directLight(p, reflection);
}
