#version 330 core
// Pictures of the decision. VIEW_LEVELS: colour of the finest level whose mask is above zero; else the edge image.
uniform sampler2D sourceTexture;  // edges, or the mask of level 0
uniform sampler2D halfMask;
uniform sampler2D quarterMask;
uniform ivec4 levelUsed;  // of levels 0, 1, 2: 1 if the frame rendered it and a coarser one
uniform int coarsestLevel;

const vec3 kLevelColors[4] = vec3[4](vec3(0.95, 0.2, 0.15), vec3(0.15, 0.8, 0.25), vec3(0.15, 0.35, 0.95), vec3(0.0));

out vec4 fragment;

// The mask of level i has texels of 2^(i + 1) pixels.
bool inZone(sampler2D mask, float texelPixels) {
    return texture(mask, gl_FragCoord.xy / (texelPixels * vec2(textureSize(mask, 0)))).r > 0.0;
}

void main() {
#if VIEW_LEVELS
    vec3 color = kLevelColors[coarsestLevel];
    if (levelUsed.z == 1 && inZone(quarterMask, 8.0)) color = kLevelColors[2];
    if (levelUsed.y == 1 && inZone(halfMask, 4.0)) color = kLevelColors[1];
    if (levelUsed.x == 1 && inZone(sourceTexture, 2.0)) color = kLevelColors[0];
    fragment = vec4(color, 1.0);
#else
    fragment = vec4(texelFetch(sourceTexture, ivec2(gl_FragCoord.xy) / 2, 0).rg, 0.0, 1.0);
#endif
}
