#version 330 core
// An edge image and the host's importance mask in one: the larger of both or, BY_MINIMUM, the smaller. What the host finds
// important needs no other reason, as steps of depth do not (green).
uniform sampler2D sourceTexture;  // edges
uniform sampler2D maskTexture;    // importance, of any size and format
uniform vec2 screenFromTexel;     // the edge image may reach half a texel beyond the screen

out vec2 fragment;

void main() {
    vec2 edges = texelFetch(sourceTexture, ivec2(gl_FragCoord.xy), 0).rg;
    float importance = texture(maskTexture, gl_FragCoord.xy * screenFromTexel).r;
#if BY_MINIMUM
    fragment = min(edges, importance);
#else
    fragment = vec2(edges.r, max(edges.g, importance));
#endif
}
