#include "host/truth/pixel_grid.h"

#include <algorithm>
#include <iterator>

namespace host {

glm::ivec2 PixelGrid::size() const {
  const glm::ivec2 period = tile * stride;
  return pictureSize / period * tile + glm::min(pictureSize % period, glm::ivec2(tile));
}

glm::ivec2 PixelGrid::pixel(glm::ivec2 point) const {
  const glm::ivec2 fromBottom(point.x, size().y - 1 - point.y);
  const glm::ivec2 place = fromBottom / tile * tile * stride + fromBottom % tile;
  return {place.x, pictureSize.y - 1 - place.y};
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
