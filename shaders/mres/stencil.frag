#version 330 core
// Passes (and so writes the stencil) where the effect renders at this level: where the mask is above zero and, with
// PROGRESSIVE, the coarser level showed that refining it makes a difference.
#include "mres/frame_params.h"
#include "mres/level.glsl"

uniform sampler2D maskTexture;
uniform sampler2D refineTexture;

void main() {
    ivec2 fullPixel = representativePixel(ivec2(gl_FragCoord.xy), size);
    if (texture(maskTexture, maskCoordinate(fullPixel)).r <= 0.0) discard;
#if PROGRESSIVE
    if (refinement(refineTexture, fullPixel) <= 0.0) discard;
#endif
}
