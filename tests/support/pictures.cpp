#include "tests/support/pictures.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "tests/support/gl_test.h"

namespace mres::test {

void refineByMasks(MultiResolution& multiResolution) {
  multiResolution.settings().technique = Technique::paper;
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

double meanAround(const Image& image, glm::ivec2 centre, int channel) {
  constexpr int kReach = 2;
  constexpr int kSide = 2 * kReach + 1;
  double sum = 0.0;
  for (int i = 0; i < kSide * kSide; ++i) {
    sum += static_cast<double>(image.at(centre + glm::ivec2(i % kSide, i / kSide) - kReach, channel));
  }
  return sum / (kSide * kSide);
}

glm::mat4 perspective(glm::ivec2 size, float verticalDegrees) {
  return glm::perspective(glm::radians(verticalDegrees),
                          static_cast<float>(size.x) / static_cast<float>(size.y), 0.1f, 100.0f);
}

glm::ivec2 pixelOf(const glm::mat4& projection, glm::ivec2 size, glm::dvec3 position) {
  const glm::dvec4 clip = glm::dmat4(projection) * glm::dvec4(position, 1.0);
  return {(glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(size)};
}

}  // namespace mres::test
