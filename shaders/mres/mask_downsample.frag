#version 330 core
// Halves the edge image: a texel is an edge if any of the four below it is (the maximum), from any source.
// JOIN_COARSER: or if it is one by itself.
uniform sampler2D sourceTexture;

uniform sampler2D maskTexture;  // edges of this resolution

out float fragment;

float edgeAt(ivec2 texel) {
    vec2 edges = texelFetch(sourceTexture, min(texel, textureSize(sourceTexture, 0) - 1), 0).rg;
    return max(edges.r, edges.g);
}

void main() {
    ivec2 corner = ivec2(gl_FragCoord.xy) * 2;
    fragment = max(max(edgeAt(corner), edgeAt(corner + ivec2(1, 0))),
                   max(edgeAt(corner + ivec2(0, 1)), edgeAt(corner + ivec2(1, 1))));
#if JOIN_COARSER
    vec2 joined = texelFetch(maskTexture, ivec2(gl_FragCoord.xy), 0).rg;
    fragment = max(fragment, max(joined.r, joined.g));
#endif
}
