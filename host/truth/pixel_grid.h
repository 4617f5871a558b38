#pragma once

#include "host/image/image_file.h"

namespace host {

/// Every stride-th pixel of a picture in both directions: columns and rows i * stride + stride / 2, rows
/// counted from the bottom as OpenGL does. Level 2 of mres is evaluated at those of stride 4 (see
/// shaders/mres/level.glsl).
struct PixelGrid {
  glm::ivec2 pictureSize{0};  ///< pixels
  int stride = 1;             ///< pixels, at least 1

  /// How many there are in each direction; 0 where the picture is too small for one.
  [[nodiscard]] glm::ivec2 size() const;

  /// Column and row in the picture of a grid point, both with rows from the top, as images have them.
  [[nodiscard]] glm::ivec2 pixel(glm::ivec2 point) const;
};

/// The values of a picture at the grid's pixels, as a picture of the grid's size.
FloatImage valuesAt(const PixelGrid& grid, const FloatImage& picture);

}  // namespace host
