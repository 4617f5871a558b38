#include "host/image/crop.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace host {

FloatImage cropAround(const FloatImage& image, glm::ivec2 centre, int side) {
  FloatImage crop{glm::min(image.size, glm::ivec2(side)), image.channels, {}};
  const glm::ivec2 corner = glm::clamp(centre - side / 2, glm::ivec2(0), image.size - crop.size);
  const auto rowLength = static_cast<std::ptrdiff_t>(crop.size.x) * image.channels;
  for (int y = 0; y < crop.size.y; ++y) {
    const std::ptrdiff_t pixel = static_cast<std::ptrdiff_t>(corner.y + y) * image.size.x + corner.x;
    std::copy_n(image.pixels.begin() + pixel * image.channels, rowLength, std::back_inserter(crop.pixels));
  }
  return crop;
}

}  // namespace host
