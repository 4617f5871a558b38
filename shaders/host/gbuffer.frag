#version 330 core
// Writes what is known of the nearest opaque surface; lighting comes later.
#include "host/material.glsl"

in vec3 worldPosition;
in vec3 worldNormal;
in vec4 worldTangent;
in vec2 texCoord;

layout(location = 0) out vec4 outAlbedo;
layout(location = 1) out vec4 outNormal;
layout(location = 2) out vec4 outGeometricNormal;
layout(location = 3) out vec4 outMaterial;
layout(location = 4) out vec3 outEmissive;

void main() {
    Surface surface = surfaceAt(worldPosition, worldNormal, worldTangent, texCoord, gl_FrontFacing);
    if (surface.alpha < alphaCutoff) discard;
    outAlbedo = vec4(surface.albedo, 1.0);
    outNormal = vec4(surface.normal * 0.5 + 0.5, 1.0);
    outGeometricNormal = vec4(surface.geometricNormal * 0.5 + 0.5, 1.0);
    outMaterial = vec4(surface.roughness, surface.metallic, 0.0, 1.0);
    outEmissive = min(surface.emissive, vec3(64000.0));  // below the largest number of the 10-bit float
}
