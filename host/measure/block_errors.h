// Errors of a picture's blocks of 8x8 pixels: in one mean over a picture, a small ugly artefact could hide.
#pragma once

#include <vector>

#include "host/image/image_file.h"

namespace host {

struct BlockErrors {
  double max = 0.0;           ///< RMS of the block that has the greatest
  double percentile99 = 0.0;  ///< RMS that 99 % of the blocks do not exceed
  glm::ivec2 worst{0};        ///< the middle of the block that has the greatest, in pixels from the top left
};

/// Of images of the same size and number of channels. Blocks at the right and at the bottom border are what
/// is left.
BlockErrors compareBlocks(const FloatImage& image, const FloatImage& reference);

/// The RMS of each block, row by row.
std::vector<double> blockErrors(const FloatImage& image, const FloatImage& reference);

}  // namespace host
