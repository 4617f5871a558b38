#include "host/truth/pixel_grid.h"

#include <algorithm>
#include <iterator>

namespace host {

glm::ivec2 PixelGrid::size() const {
  return (pictureSize - stride / 2 + stride - 1) / stride;
}

glm::ivec2 PixelGrid::pixel(glm::ivec2 point) const {
  const int rowFromBottom = (size().y - 1 - point.y) * stride + stride / 2;
  return {point.x * stride + stride / 2, pictureSize.y - 1 - rowFromBottom};
}

FloatImage valuesAt(const PixelGrid& grid, const FloatImage& picture) {
  FloatImage values{grid.size(), picture.channels, {}};
  for (int y = 0; y < values.size.y; ++y)
    for (int x = 0; x < values.size.x; ++x) {
      const glm::ivec2 pixel = grid.pixel({x, y});
      const auto first =
          picture.pixels.begin() + (std::ptrdiff_t{pixel.y} * picture.size.x + pixel.x) * picture.channels;
      std::copy_n(first, picture.channels, std::back_inserter(values.pixels));
    }
  return values;
}

}  // namespace host
