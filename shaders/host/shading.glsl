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
};

vec3 sunLight(ShadingPoint p) {
    if (sunIlluminance.rgb == vec3(0.0) || dot(p.geometricNormal, directionToSun.xyz) <= 0.0) return vec3(0.0);
    vec3 share = reflectedShare(p.albedo, p.metallic, p.roughness, p.normal, p.toViewer, directionToSun.xyz);
    if (share == vec3(0.0)) return vec3(0.0);
    return share * sunIlluminance.rgb * sunVisibility(p.position, p.geometricNormal);
}

vec3 punctualLight(ShadingPoint p) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < lightCount; ++i) {
        vec3 toLight;
        vec3 received = illuminance(i, p.position, toLight);
        if (received == vec3(0.0)) continue;
        sum += received * reflectedShare(p.albedo, p.metallic, p.roughness, p.normal, p.toViewer, toLight);
    }
    return sum;
}

// Uniform light from each side: what is reflected diffusely, and in highlights from where the mirror direction looks.
vec3 ambientLight(ShadingPoint p, float accessibility) {
    vec3 f0 = mix(vec3(kDielectricF0), p.albedo, p.metallic);
    float nDotV = clamp(dot(p.normal, p.toViewer), 0.0, 1.0);
    vec3 mirrored = reflectedAmbientShare(f0, p.roughness, nDotV);
    vec3 diffuse = (1.0 - mirrored) * (1.0 - p.metallic) * p.albedo;
    vec3 mirrorDirection = normalize(mix(reflect(-p.toViewer, p.normal), p.normal, p.roughness * p.roughness));
    return (diffuse * ambientRadiance(p.normal) + mirrored * ambientRadiance(mirrorDirection)) * accessibility;
}

vec3 shade(ShadingPoint p, vec3 emissive, float accessibility) {
    return emissive + ambientLight(p, accessibility) + sunLight(p) + punctualLight(p);
}
