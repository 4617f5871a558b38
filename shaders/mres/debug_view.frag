#version 330 core
// Pictures of the decision. VIEW_LEVELS: colour of the finest level that renders a pixel; else the edge image.
#include "mres/level_params.h"

uniform sampler2D sourceTexture;  // geometry's edges, or the zone of level 0
uniform sampler2D maskTexture;    // the effect's edges
uniform sampler2D halfZone;
uniform sampler2D quarterZone;
uniform ivec4 levelUsed;  // of levels 0, 1, 2: 1 if the frame rendered it and a coarser one
uniform int coarsestLevel;

const vec3 kLevelColors[4] = vec3[4](vec3(0.95, 0.2, 0.15), vec3(0.15, 0.8, 0.25), vec3(0.15, 0.35, 0.95), vec3(0.0));

out vec4 fragment;

bool inZone(sampler2D zone, int levelStride) {
    return texelFetch(zone, ivec2(gl_FragCoord.xy) / (levelStride * ZONE_BLOCK), 0).r > 0.0;
}

void main() {
#if VIEW_LEVELS
    vec3 color = kLevelColors[coarsestLevel];
    if (levelUsed.z == 1 && inZone(quarterZone, 4)) color = kLevelColors[2];
    if (levelUsed.y == 1 && inZone(halfZone, 2)) color = kLevelColors[1];
    if (levelUsed.x == 1 && inZone(sourceTexture, 1)) color = kLevelColors[0];
    fragment = vec4(color, 1.0);
#else
    ivec2 texel = ivec2(gl_FragCoord.xy) / 2;
    fragment = vec4(texelFetch(sourceTexture, texel, 0).rg, texelFetch(maskTexture, texel, 0).r, 1.0);
#endif
}
