#pragma once

#include "host/image/image_file.h"

namespace host {

/// A part of a picture's pixels that depends on no content: every stride-th of its tiles in both directions,
/// the first one at the lower left. mres evaluates its levels at every second, fourth and eighth pixel; with
/// odd strides a grid meets those and all pixels between them equally often, and so what upsampling gets
/// wrong as well.
struct PixelGrid {
  glm::ivec2 pictureSize{0};  ///< pixels
  int tile = 1;               ///< pixels a side, at least 1
  glm::ivec2 stride{1};       ///< tiles, at least 1

  /// How many pixels there are in each direction.
  [[nodiscard]] glm::ivec2 size() const;

  /// Column and row in the picture of a grid point, both with rows from the top, as images have them.
  [[nodiscard]] glm::ivec2 pixel(glm::ivec2 point) const;
};

/// The values of a picture at the grid's pixels, as a picture of the grid's size.
FloatImage valuesAt(const PixelGrid& grid, const FloatImage& picture);

}  // namespace host
