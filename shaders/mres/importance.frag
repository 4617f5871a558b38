#version 330 core
// An edge image and the host's importance mask in one: the larger of both or, BY_MINIMUM, the smaller.
uniform sampler2D sourceTexture;  // edges
uniform sampler2D maskTexture;    // importance, of any size and format
uniform vec2 screenFromTexel;     // the edge image may reach half a texel beyond the screen

out float fragment;

void main() {
    vec2 edges = texelFetch(sourceTexture, ivec2(gl_FragCoord.xy), 0).rg;
    float importance = texture(maskTexture, gl_FragCoord.xy * screenFromTexel).r;
    float edge = max(edges.r, edges.g);
#if BY_MINIMUM
    fragment = min(edge, importance);
#else
    fragment = max(edge, importance);
#endif
}
