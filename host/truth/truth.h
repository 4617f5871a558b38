#pragma once

#include <string>

#include "host/truth/pixel_grid.h"

namespace host {

/// What an effect's picture should be, at a subset of its pixels that depends on no content.
struct Truth {
  std::string name;  ///< "converged" or "ray_traced", as reports have it
  std::string unit;  ///< what `count` counts: "samples" or "rays"
  int count = 0;     ///< for each pixel
  PixelGrid grid;
  FloatImage values;  ///< of the grid's size, the effect's values
};

}  // namespace host
