// The level that renders each tile of ADAPTIVE_TILE x ADAPTIVE_TILE pixels of the full resolution.
#include "mres/level_params.h"
#include "peers/peer_blocks.h"

const float kCoarsestTileLevel = 2.0;

uniform sampler2D zoneTexture;  // a texel a tile: its level, as a share of the coarsest one

float rateOfLevel(float level) { return level / kCoarsestTileLevel; }

bool isInTileOfThisLevel(ivec2 levelPixel) {
    float rate = texelFetch(zoneTexture, levelPixel * levelStride / ADAPTIVE_TILE, 0).r;
    return 1 << int(rate * kCoarsestTileLevel + 0.5) == levelStride;
}
