#version 330 core
// The mask of a level: the edge image blurred by a Gaussian, whose variance sets the width of the zone.
// JOIN_FINER: whether the finer level's mask is joined in, where the Gaussian alone would not contain its zone.
#include "mres/mask_blur_params.h"

uniform sampler2D sourceTexture;

out float fragment;

float edgeAt(ivec2 texel) {
    vec2 edges = texelFetch(sourceTexture, clamp(texel, ivec2(0), textureSize(sourceTexture, 0) - 1), 0).rg;
    return max(edges.r, edges.g);
}

float weightAt(int distance) {
    return weights[distance >> 2][distance & 3];
}

#if JOIN_FINER
uniform sampler2D finerMaskTexture;

// A finer mask above zero anywhere below this texel keeps it above zero.
float finerSupport(ivec2 texel) {
    ivec2 last = textureSize(finerMaskTexture, 0) - 1;
    float support = 0.0;
    for (int i = 0; i < finerRatio * finerRatio; ++i) {
        ivec2 finer = texel * finerRatio + ivec2(i % finerRatio, i / finerRatio);
        support = max(support, texelFetch(finerMaskTexture, min(finer, last), 0).r);
    }
    return support > 0.0 ? 1.0 : 0.0;
}
#endif

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    float sum = edgeAt(texel) * weightAt(0);
    for (int distance = 1; distance <= radius; ++distance) {
        sum += (edgeAt(texel - axis * distance) + edgeAt(texel + axis * distance)) * weightAt(distance);
    }
    fragment = sum;
#if JOIN_FINER
    fragment = max(fragment, finerSupport(texel));
#endif
}
