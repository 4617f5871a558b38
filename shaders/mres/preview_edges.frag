#version 330 core
// Edges of an effect's preview, red: where the values that a pixel and its neighbours may have are further apart than is worth
// refining. WITH_GEOMETRY: green takes the geometry's edges in.
uniform sampler2D sourceTexture;  // least and largest value
uniform sampler2D maskTexture;    // geometry edges
uniform float threshold;

out vec2 fragment;

vec2 boundsAt(ivec2 texel) {
    return texelFetch(sourceTexture, clamp(texel, ivec2(0), textureSize(sourceTexture, 0) - 1), 0).rg;
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec2 here = boundsAt(texel);
    vec2 left = boundsAt(texel - ivec2(1, 0)), right = boundsAt(texel + ivec2(1, 0));
    vec2 below = boundsAt(texel - ivec2(0, 1)), above = boundsAt(texel + ivec2(0, 1));
    float least = min(here.r, min(min(left.r, right.r), min(below.r, above.r)));
    float largest = max(here.g, max(max(left.g, right.g), max(below.g, above.g)));
    fragment = vec2(largest - least > threshold ? 1.0 : 0.0, 0.0);
#if WITH_GEOMETRY
    vec2 geometry = texelFetch(maskTexture, texel, 0).rg;
    fragment.g = max(geometry.r, geometry.g);
#endif
}
