#include "effects/common/sample_points.h"

#include <algorithm>
#include <cmath>

namespace mres {
namespace {

/// The R3 sequence: inverse powers of the root of x^4 = x + 1, a low-discrepancy set in three dimensions
/// (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences").
constexpr glm::dvec3 kR3(0.8191725133961645, 0.6710436067037893, 0.5497004779019703);

constexpr double kTwoPi = 6.283185307179586;

}  // namespace

std::vector<glm::vec3> hemispherePoints(int count, int seed) {
  std::vector<glm::vec3> points;
  points.reserve(static_cast<std::size_t>(count));
  const glm::dvec3 start =
      glm::fract(static_cast<double>(seed) * glm::dvec3(0.754877666, 0.569840296, 0.618033989));
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 u = glm::fract(start + (i + 0.5) * kR3);
    const double sine = std::sqrt(u.x);  // cosine-weighted: sin^2 of the angle to the normal is uniform
    const double cosine = std::sqrt(1.0 - u.x);
    const glm::dvec3 direction(sine * std::cos(kTwoPi * u.y), sine * std::sin(kTwoPi * u.y), cosine);
    const double distance = (i + u.z) / count;
    points.emplace_back(direction * std::max(distance, 1e-3));
  }
  return points;
}

std::vector<glm::vec4> hemispherePointsForShader(int count, int seed) {
  std::vector<glm::vec4> points;
  points.reserve(static_cast<std::size_t>(count));
  for (const glm::vec3 point : hemispherePoints(count, seed)) {
    points.emplace_back(point, std::log2(glm::length(point)));
  }
  return points;
}

}  // namespace mres
