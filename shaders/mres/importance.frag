#version 330 core
// An edge image and the host's importance mask in one. COMBINE: max or min.
uniform sampler2D sourceTexture;  // edges
uniform sampler2D maskTexture;    // importance, of any size and format
uniform vec2 screenFromTexel;     // the edge image may reach half a texel beyond the screen

out float fragment;

void main() {
    vec2 edges = texelFetch(sourceTexture, ivec2(gl_FragCoord.xy), 0).rg;
    float importance = texture(maskTexture, gl_FragCoord.xy * screenFromTexel).r;
    fragment = COMBINE(max(edges.r, edges.g), importance);
}
