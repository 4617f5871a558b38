#include "effects/soft_shadows/disk_samples.h"

#include <algorithm>
#include <cmath>

namespace mres {
namespace {

constexpr double kGoldenAngle = 2.399963229728653;

glm::vec2 onSpiral(double radius, double turn) {
  return {radius * std::cos(turn), radius * std::sin(turn)};
}

}  // namespace

std::vector<glm::vec2> diskSamples(int count, int seed) {
  std::vector<glm::vec2> samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    samples.push_back(onSpiral(std::sqrt((i + 0.5) / count), i * kGoldenAngle + seed));
  return samples;
}

std::vector<glm::vec2> diskSamplesToTheRim(int count, int seed) {
  std::vector<glm::vec2> samples = diskSamples(count, seed);
  const float outermost = glm::length(samples.back());
  for (glm::vec2& sample : samples) sample /= outermost;
  return samples;
}

}  // namespace mres
