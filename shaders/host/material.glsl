// Reads a material's textures at a fragment: everything that the passes need to know of its surface.
#include "host/material_params.h"

uniform sampler2D baseColorTexture;
uniform sampler2D metallicRoughnessTexture;
uniform sampler2D normalTexture;
uniform sampler2D emissiveTexture;

struct Surface {
    vec3 albedo;
    float alpha;
    vec3 normal;           // with the normal map
    vec3 geometricNormal;  // without
    float roughness;       // perceptual
    float metallic;
    vec3 emissive;
};

vec2 transformUv(vec4 rows[UV_ROWS], vec2 uv) {
    return vec2(dot(rows[0].xyz, vec3(uv, 1.0)), dot(rows[1].xyz, vec3(uv, 1.0)));
}

vec4 baseColorAt(vec2 uv) {
    return baseColorFactor * texture(baseColorTexture, transformUv(baseColorUv, uv));
}

// The interpolated vertex normal on the side that is seen; the triangle's own where a mesh has none.
vec3 geometricNormalAt(vec3 position, vec3 vertexNormal, bool front) {
    float squared = dot(vertexNormal, vertexNormal);
    if (squared < 1e-8) return normalize(cross(dFdx(position), dFdy(position)));  // faces the viewer by itself
    return vertexNormal * (front ? inversesqrt(squared) : -inversesqrt(squared));
}

// The frame of glTF: the bitangent is cross(normal, tangent) * handedness.
vec3 shadingNormalAt(vec3 normal, vec4 tangent, vec2 uv, bool front) {
    vec3 mapped = texture(normalTexture, transformUv(normalUv, uv)).xyz * 2.0 - 1.0;
    mapped.xy *= normalScale;
    vec3 tangentDirection = tangent.xyz - normal * dot(normal, tangent.xyz);
    float squared = dot(tangentDirection, tangentDirection);
    if (squared < 1e-8) return normal;
    tangentDirection *= inversesqrt(squared);
    // On a back face `normal` is already turned; the frame of the map turns as a whole.
    vec3 bitangent = cross(normal, tangentDirection) * (front ? tangent.w : -tangent.w);
    return normalize(tangentDirection * mapped.x + bitangent * mapped.y + normal * max(mapped.z, 1e-3));
}

Surface surfaceAt(vec3 position, vec3 vertexNormal, vec4 tangent, vec2 uv, bool front) {
    Surface surface;
    vec4 baseColor = baseColorAt(uv);
    surface.albedo = baseColor.rgb;
    surface.alpha = baseColor.a;
    surface.geometricNormal = geometricNormalAt(position, vertexNormal, front);
    surface.normal = shadingNormalAt(surface.geometricNormal, tangent, uv, front);
    vec2 roughnessMetallic = texture(metallicRoughnessTexture, transformUv(metallicRoughnessUv, uv)).gb;
    surface.roughness = clamp(roughnessFactor * roughnessMetallic.x, 0.0, 1.0);
    surface.metallic = clamp(metallicFactor * roughnessMetallic.y, 0.0, 1.0);
    surface.emissive = emissiveFactor.rgb * texture(emissiveTexture, transformUv(emissiveUv, uv)).rgb;
    return surface;
}
