#version 330 core
// Edges of an effect's preview, red: where the values that a pixel and its neighbours to the right and above may have are
// further apart than is worth refining. WITH_GEOMETRY: green takes the geometry's edges in.
uniform sampler2D sourceTexture;  // least and largest value
uniform sampler2D maskTexture;    // geometry edges
uniform float threshold;

out vec2 fragment;

vec2 boundsAt(ivec2 texel) {
    return texelFetch(sourceTexture, min(texel, textureSize(sourceTexture, 0) - 1), 0).rg;
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec2 a = boundsAt(texel), b = boundsAt(texel + ivec2(1, 0));
    vec2 c = boundsAt(texel + ivec2(0, 1)), d = boundsAt(texel + ivec2(1, 1));
    float least = min(min(a.r, b.r), min(c.r, d.r));
    float largest = max(max(a.g, b.g), max(c.g, d.g));
    fragment = vec2(largest - least > threshold ? 1.0 : 0.0, 0.0);
#if WITH_GEOMETRY
    vec2 geometry = texelFetch(maskTexture, texel, 0).rg;
    fragment.g = max(geometry.r, geometry.g);
#endif
}
