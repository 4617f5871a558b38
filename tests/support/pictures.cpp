#include "tests/support/pictures.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "tests/support/gl_test.h"

namespace mres::test {

void refineAtEveryEdge(MultiResolution& multiResolution) {
  multiResolution.settings().mask.refineThreshold = 0.0f;
}

Picture renderPicture(MultiResolution& multiResolution, Effect& effect, const Frame& frame) {
  return readPixels(multiResolution.render(effect, frame), frame.size, effect.description().channels);
}

double maxDifference(const Picture& a, const Picture& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
    largest =
        std::isfinite(difference) ? std::max(largest, difference) : std::numeric_limits<double>::infinity();
  }
  return largest;
}

double rootMeanSquare(const Picture& a, const Picture& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

bool isFinite(const Picture& picture) {
  return std::ranges::all_of(picture, [](float value) { return std::isfinite(value); });
}

glm::mat4 perspective(glm::ivec2 size, float verticalDegrees) {
  return glm::perspective(glm::radians(verticalDegrees),
                          static_cast<float>(size.x) / static_cast<float>(size.y), 0.1f, 100.0f);
}

}  // namespace mres::test
