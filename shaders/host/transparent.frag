#version 330 core
// Shades an alpha-blended surface; blending over what lies behind is the pipeline's.
#include "host/material.glsl"
#include "host/shading.glsl"
#include "host/view.glsl"

in vec3 worldPosition;
in vec3 worldNormal;
in vec4 worldTangent;
in vec2 texCoord;

out vec4 outRadiance;

void main() {
    Surface surface = surfaceAt(worldPosition, worldNormal, worldTangent, texCoord, gl_FrontFacing);
    ShadingPoint point;
    point.position = worldPosition;
    point.toViewer = directionToViewer(worldPosition);
    point.albedo = surface.albedo;
    point.normal = surface.normal;
    point.geometricNormal = surface.geometricNormal;
    point.roughness = surface.roughness;
    point.metallic = surface.metallic;
    point.visibility = kLookUpShadow;
    point.indirect = diffuseAmbient(point.normal);
    point.accessibility = 1.0;
    outRadiance = vec4(shade(point, surface.emissive), surface.alpha);
}
