// The four texels of the coarser level that a pixel of this level lies between.
#include "mres/frame_params.h"
#include "mres/level.glsl"

uniform sampler2D coarserTexture;  // the picture down to the coarser level

struct Footprint {
    ivec2 corner;  // the first texel; may lie off the level
    vec4 shares;   // bilinear, of corner + (0, 0), (1, 0), (0, 1), (1, 1)
};

Footprint footprintAt(vec2 place) {
    vec2 texel = coarserCoordinate(place) * vec2(textureSize(coarserTexture, 0)) - 0.5;
    vec2 corner = floor(texel);
    vec2 share = texel - corner;
    vec2 rest = 1.0 - share;
    return Footprint(ivec2(corner), vec4(rest, share).xzxz * vec4(rest.yy, share.yy));
}

ivec2 texelOf(Footprint footprint, int i) {
    return clamp(footprint.corner + ivec2(i & 1, i >> 1), ivec2(0), textureSize(coarserTexture, 0) - 1);
}
