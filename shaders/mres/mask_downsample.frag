#version 330 core
// Halves the edge image: a texel is an edge if any of the four below it is (the maximum). JOIN_COARSER: or if it is one by
// itself.
uniform sampler2D sourceTexture;

uniform sampler2D maskTexture;  // edges of this resolution

out vec2 fragment;

vec2 edgesAt(ivec2 texel) {
    return texelFetch(sourceTexture, min(texel, textureSize(sourceTexture, 0) - 1), 0).rg;
}

void main() {
    ivec2 corner = ivec2(gl_FragCoord.xy) * 2;
    fragment = max(max(edgesAt(corner), edgesAt(corner + ivec2(1, 0))),
                   max(edgesAt(corner + ivec2(0, 1)), edgesAt(corner + ivec2(1, 1))));
#if JOIN_COARSER
    fragment = max(fragment, texelFetch(maskTexture, ivec2(gl_FragCoord.xy), 0).rg);
#endif
}
