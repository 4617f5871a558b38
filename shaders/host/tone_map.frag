#version 330 core
// Radiance to what a screen shows.
#include "host/tone_map_params.h"

uniform sampler2D radianceTexture;

out vec4 outColor;

// Khronos PBR Neutral (Khronos Group 2024, "PBR Neutral Tone Mapper"): keeps the colours of what is lit evenly,
// compresses only highlights, and bleaches those.
vec3 pbrNeutral(vec3 color) {
    const float kStartCompression = 0.8 - 0.04;  // 0.04: what a dielectric adds to its base colour
    const float kDesaturation = 0.15;
    float least = min(color.r, min(color.g, color.b));
    color -= least < 0.08 ? least - 6.25 * least * least : 0.04;
    float peak = max(color.r, max(color.g, color.b));
    if (peak < kStartCompression) return color;
    float d = 1.0 - kStartCompression;
    float newPeak = 1.0 - d * d / (peak + d - kStartCompression);
    color *= newPeak / peak;
    float bleach = 1.0 - 1.0 / (kDesaturation * (peak - newPeak) + 1.0);
    return mix(color, vec3(newPeak), bleach);
}

// IEC 61966-2-1.
vec3 encodeSrgb(vec3 linear) {
    vec3 curve = 1.055 * pow(max(linear, 0.0031308), vec3(1.0 / 2.4)) - 0.055;
    return mix(12.92 * linear, curve, greaterThan(linear, vec3(0.0031308)));
}

void main() {
    vec3 radiance = texelFetch(radianceTexture, ivec2(gl_FragCoord.xy), 0).rgb;
    outColor = vec4(encodeSrgb(clamp(pbrNeutral(radiance * exposure), 0.0, 1.0)), 1.0);
}
