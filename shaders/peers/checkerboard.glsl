// A checkerboard of blocks of CHECKERBOARD_BLOCK x CHECKERBOARD_BLOCK pixels, of which the white ones, (0, 0) among them,
// are evaluated: packed side by side into a target of half the width.
//
// Packed, every pixel that a rasteriser shades is wanted, whether it shades blocks of 4x4 (llvmpipe) or quads (GPUs), and
// without a stencil. So the block can be as small as the effect's noise likes it: of the sixteen rotations of the 4x4
// pattern (effects/common/rotation_pattern.glsl), single pixels would see the eight in one half of the circle, blocks of 2x2
// see twice four quarter turns, a sixteenth of a turn apart. Blocks of 4x4 would see all, but the pixels to fill would lie
// up to four from the next evaluated one, and their outermost pixels alone would fill them: 1 and 2 are what there is.
#include "peers/peer_blocks.h"

// The pixel that a packed texel is of; may lie off the screen.
ivec2 pixelOfTexel(ivec2 texel) {
    ivec2 block = texel / CHECKERBOARD_BLOCK;
    return ivec2(2 * block.x + (block.y & 1), block.y) * CHECKERBOARD_BLOCK + texel % CHECKERBOARD_BLOCK;
}

bool isEvaluated(ivec2 pixel) {
    ivec2 block = pixel / CHECKERBOARD_BLOCK;
    return ((block.x + block.y) & 1) == 0;
}

// Of a pixel that is evaluated.
ivec2 texelOfPixel(ivec2 pixel) {
    ivec2 block = pixel / CHECKERBOARD_BLOCK;
    return ivec2(block.x >> 1, block.y) * CHECKERBOARD_BLOCK + pixel % CHECKERBOARD_BLOCK;
}
