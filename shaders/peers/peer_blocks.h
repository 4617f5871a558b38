// Sizes of the peers' patterns: read by C++ and GLSL.
#pragma once

#define CHECKERBOARD_BLOCK 2  // pixels; see checkerboard.glsl
#define INTERLEAVED_PHASES 4  // along an axis: the effects' noise repeats after as many pixels of the full resolution
#define ADAPTIVE_TILE 16      // pixels, as the shading-rate images of GPUs have them; blocks of 4x4 of every level
