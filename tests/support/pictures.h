#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "mres/mres.h"

namespace mres::test {

using Picture = std::vector<float>;

/// One channel or more of a small picture, with its size.
struct Image {
  glm::ivec2 size{0};
  int channels = 1;
  std::vector<float> texels;
  [[nodiscard]] float at(glm::ivec2 texel, int channel = 0) const {
    return texels.at(static_cast<std::size_t>((texel.y * size.x + texel.x) * channels + channel));
  }
};

/// Lets blurred masks decide and blend, as the paper does.
void refineByMasks(MultiResolution& multiResolution);

/// Renders and reads the result, all its channels.
Picture renderPicture(MultiResolution& multiResolution, Effect& effect, const Frame& frame);

/// NaN and infinities count as infinitely far off.
double maxDifference(const Picture& a, const Picture& b);
double rootMeanSquare(const Picture& a, const Picture& b);
bool isFinite(const Picture& picture);

/// Mean over a square of pixels.
double meanAround(const Image& image, glm::ivec2 centre, int channel = 0);

/// A perspective projection with near plane 0.1 m and far plane 100 m.
glm::mat4 perspective(glm::ivec2 size, float verticalDegrees = 60.0f);

/// The pixel that shows a view-space position.
glm::ivec2 pixelOf(const glm::mat4& projection, glm::ivec2 size, glm::dvec3 position);

}  // namespace mres::test
