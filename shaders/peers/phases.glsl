// De-interleaved, as in nvpro's gl_ssao and Intel's ASSAO: pixels of the same phase of the noise pattern lie side by side,
// in sixteen tiles of one target, so that neighbours look in the same directions and fetch what lies side by side, too.
// Depth itself is not split into phases, as it is there: values are to be those of the full resolution.
#include "mres/level_params.h"
#include "peers/peer_blocks.h"

ivec2 phaseSize() { return (levelSize + INTERLEAVED_PHASES - 1) / INTERLEAVED_PHASES; }

// The pixel that a texel of the tiles is of; may lie off the screen.
ivec2 pixelOfTexel(ivec2 texel) {
    ivec2 tile = phaseSize();
    return texel % tile * INTERLEAVED_PHASES + texel / tile;
}

ivec2 texelOfPixel(ivec2 pixel) {
    return pixel % INTERLEAVED_PHASES * phaseSize() + pixel / INTERLEAVED_PHASES;
}
