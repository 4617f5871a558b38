#version 330 core
// Passes (and so writes the stencil) where the level's mask is above zero: there the effect renders.
#include "mres/frame_params.h"
#include "mres/level.glsl"

uniform sampler2D maskTexture;

void main() {
    ivec2 fullPixel = representativePixel(ivec2(gl_FragCoord.xy), size);
    if (texture(maskTexture, maskCoordinate(fullPixel)).r <= 0.0) discard;
}
