#version 330 core
// Lights the G-buffer; where it is empty, shows the sky.
#include "host/shading.glsl"
#include "host/view.glsl"

uniform sampler2D depthTexture;
uniform sampler2D albedoTexture;
uniform sampler2D normalTexture;
uniform sampler2D geometricNormalTexture;
uniform sampler2D materialTexture;
uniform sampler2D emissiveTexture;
uniform sampler2D accessibilityTexture;
uniform sampler2D visibilityTexture;
uniform sampler2D indirectTexture;
uniform bool hasIndirect;       // else ambient light is dimmed by the accessibility
uniform float indirectScale;    // takes the exposure back
uniform bool hasVisibility;     // else shadows are looked up here

out vec4 outRadiance;

// No radiance to speak of: a scene may be without ambient light.
const float kDark = 1e-6;

vec3 unpackNormal(vec4 packedNormal) { return normalize(packedNormal.xyz * 2.0 - 1.0); }

// ITU-R BT.709.
float luminance(vec3 color) { return dot(color, vec3(0.2126, 0.7152, 0.0722)); }

void receiveAmbient(inout ShadingPoint point, float accessibility) {
    point.indirect = diffuseAmbient(point.normal) * accessibility;
    point.accessibility = accessibility;
}

// `arriving` is irradiance / pi by the geometric normal; the normal map changes it as it changes ambient light. Highlights
// mirror as large a part of the ambient light as arrives.
void receiveIndirect(inout ShadingPoint point, vec3 arriving) {
    vec3 unoccluded = diffuseAmbient(point.geometricNormal);
    point.indirect = arriving * (diffuseAmbient(point.normal) + kDark) / (unoccluded + kDark);
    point.accessibility = clamp(luminance(arriving) / max(luminance(unoccluded), kDark), 0.0, 1.0);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 uv = gl_FragCoord.xy / vec2(textureSize(depthTexture, 0));
    float depth = texelFetch(depthTexture, pixel, 0).r;
    if (depth == 1.0) {
        outRadiance = vec4(skyRadiance(-directionToViewer(positionAt(uv, 0.0))), 1.0);
        return;
    }
    vec2 material = texelFetch(materialTexture, pixel, 0).rg;
    ShadingPoint point;
    point.position = positionAt(uv, depth);
    point.toViewer = directionToViewer(point.position);
    point.albedo = texelFetch(albedoTexture, pixel, 0).rgb;
    point.normal = unpackNormal(texelFetch(normalTexture, pixel, 0));
    point.geometricNormal = unpackNormal(texelFetch(geometricNormalTexture, pixel, 0));
    point.roughness = material.r;
    point.metallic = material.g;
    point.visibility = hasVisibility ? texelFetch(visibilityTexture, pixel, 0).r : kLookUpShadow;
    if (hasIndirect)
        receiveIndirect(point, texelFetch(indirectTexture, pixel, 0).rgb * indirectScale);
    else
        receiveAmbient(point, texture(accessibilityTexture, uv).r);  // one white texel where there is no occlusion
    outRadiance = vec4(shade(point, texelFetch(emissiveTexture, pixel, 0).rgb), 1.0);
}
