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
uniform sampler2D sunVisibilityTexture;
uniform sampler2D indirectTexture;
uniform bool hasIndirect;       // else diffuse ambient light is dimmed by the accessibility
uniform float indirectScale;    // takes the exposure back
uniform bool hasSunVisibility;  // else the sun's shadows are looked up here

out vec4 outRadiance;

vec3 unpackNormal(vec4 packedNormal) { return normalize(packedNormal.xyz * 2.0 - 1.0); }

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
    point.sunVisibility = hasSunVisibility ? texelFetch(sunVisibilityTexture, pixel, 0).r : kLookUpShadow;
    float accessibility = texture(accessibilityTexture, uv).r;  // one white texel where there is no occlusion
    point.indirect = hasIndirect ? texelFetch(indirectTexture, pixel, 0).rgb * indirectScale
                                 : ambientRadiance(point.normal) * accessibility;
    outRadiance = vec4(shade(point, texelFetch(emissiveTexture, pixel, 0).rgb, accessibility), 1.0);
}
