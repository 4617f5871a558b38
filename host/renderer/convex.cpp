#include "host/renderer/convex.h"

namespace host {
namespace {

using Polygon = std::vector<glm::vec3>;

/// The six faces by the indices of their corners, going around.
constexpr std::array<std::array<std::size_t, 4>, 6> kFaces = {
    {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};

/// Sutherland and Hodgman 1974, "Reentrant polygon clipping", against one plane.
Polygon clipped(const Polygon& polygon, const glm::vec4& plane) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::vec3& from = polygon[i];
    const glm::vec3& to = polygon[(i + 1) % polygon.size()];
    const float fromDistance = glm::dot(plane, glm::vec4(from, 1.0f));
    const float toDistance = glm::dot(plane, glm::vec4(to, 1.0f));
    if (fromDistance >= 0.0f) result.push_back(from);
    if ((fromDistance >= 0.0f) != (toDistance >= 0.0f)) {
      result.push_back(glm::mix(from, to, fromDistance / (fromDistance - toDistance)));
    }
  }
  return result;
}

void appendClippedFaces(std::vector<glm::vec3>& points, const Corners& solid,
                        std::span<const glm::vec4> planes) {
  for (const auto& face : kFaces) {
    Polygon polygon = {solid[face[0]], solid[face[1]], solid[face[2]], solid[face[3]]};
    for (const glm::vec4& plane : planes) polygon = clipped(polygon, plane);
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
}

}  // namespace

Corners cornersOf(const Bounds& box) {
  Corners corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = {(i & 1U) != 0U ? box.max.x : box.min.x, (i & 2U) != 0U ? box.max.y : box.min.y,
                  (i & 4U) != 0U ? box.max.z : box.min.z};
  }
  return corners;
}

std::array<glm::vec4, 6> planesOf(const Bounds& box) {
  return {glm::vec4(1.0f, 0.0f, 0.0f, -box.min.x), glm::vec4(-1.0f, 0.0f, 0.0f, box.max.x),
          glm::vec4(0.0f, 1.0f, 0.0f, -box.min.y), glm::vec4(0.0f, -1.0f, 0.0f, box.max.y),
          glm::vec4(0.0f, 0.0f, 1.0f, -box.min.z), glm::vec4(0.0f, 0.0f, -1.0f, box.max.z)};
}

std::vector<glm::vec3> intersectionPoints(const Corners& a, std::span<const glm::vec4> planesOfA,
                                          const Corners& b, std::span<const glm::vec4> planesOfB) {
  std::vector<glm::vec3> points;
  appendClippedFaces(points, a, planesOfB);
  appendClippedFaces(points, b, planesOfA);
  return points;
}

}  // namespace host
