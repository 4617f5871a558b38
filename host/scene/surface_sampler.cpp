#include "host/scene/surface_sampler.h"

#include <algorithm>
#include <cmath>

namespace host {
namespace {

glm::dvec3 areaNormal(const WorldTriangle& triangle) {
  const glm::dvec3 origin(triangle.corners[0]);
  return glm::cross(glm::dvec3(triangle.corners[1]) - origin, glm::dvec3(triangle.corners[2]) - origin);
}

}  // namespace

float radicalInverse(int base, int i) {
  float result = 0.0f;
  float digit = 1.0f / float(base);
  for (; i > 0; i /= base, digit /= float(base)) result += float(i % base) * digit;
  return result;
}

SurfaceSampler::SurfaceSampler(const TriangleGrid& grid) : triangles_(grid.triangles()) {
  cumulativeWeights_.reserve(triangles_.size());
  double sum = 0.0;
  for (const WorldTriangle& triangle : triangles_) {
    sum += std::sqrt(glm::length(areaNormal(triangle)));
    cumulativeWeights_.push_back(sum);
  }
}

SurfaceSampler::Sample SurfaceSampler::sample(int i) const {
  const double target = double(radicalInverse(2, i + 1)) * cumulativeWeights_.back();
  const auto found = std::upper_bound(cumulativeWeights_.begin(), cumulativeWeights_.end(), target);
  const auto index = std::min(std::size_t(found - cumulativeWeights_.begin()), triangles_.size() - 1);
  const WorldTriangle& triangle = triangles_[index];
  const float root = std::sqrt(radicalInverse(3, i + 1));
  const float v = radicalInverse(5, i + 1);
  const auto& [a, b, c] = triangle.corners;
  const glm::dvec3 normal = areaNormal(triangle);
  const double length = glm::length(normal);
  return {a * (1.0f - root) + b * (root * (1.0f - v)) + c * (root * v),
          length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f, 1.0f, 0.0f)};
}

}  // namespace host
