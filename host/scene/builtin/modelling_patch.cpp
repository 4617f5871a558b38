#include <algorithm>

#include "host/scene/builtin/modelling.h"
#include "host/scene/builtin/surface_grid.h"

namespace host::modelling {
namespace {

using Surface = std::function<glm::vec3(float, float)>;

constexpr float kStep = 4e-3f;  // of the parameter, for finite differences

glm::vec3 slopeAlongU(const Surface& surface, float u, float v) {
  return surface(std::min(u + kStep, 1.0f), v) - surface(std::max(u - kStep, 0.0f), v);
}

glm::vec3 slopeAlongV(const Surface& surface, float u, float v) {
  return surface(u, std::min(v + kStep, 1.0f)) - surface(u, std::max(v - kStep, 0.0f));
}

/// Where an edge collapses to a point the normal is undefined: take the one a little farther in.
glm::vec3 normalAt(const Surface& surface, float u, float v) {
  for (const float inwards : {0.0f, 0.01f, 0.05f}) {
    const float nearU = glm::mix(u, 0.5f, inwards);
    const float nearV = glm::mix(v, 0.5f, inwards);
    const glm::vec3 along = slopeAlongU(surface, nearU, nearV);
    const glm::vec3 up = slopeAlongV(surface, nearU, nearV);
    const glm::vec3 normal = glm::cross(along, up);
    if (glm::length(normal) > 1e-2f * glm::length(along) * glm::length(up) && glm::length(normal) > 1e-12f) {
      return glm::normalize(normal);
    }
  }
  return {0.0f, 1.0f, 0.0f};
}

/// Length of the patch's middle line along u or v, in metres.
float middleLength(const Surface& surface, int segments, bool alongU) {
  const auto at = [&](int i) {
    const float t = static_cast<float>(i) / static_cast<float>(segments);
    return alongU ? surface(t, 0.5f) : surface(0.5f, t);
  };
  float length = 0.0f;
  for (int i = 0; i < segments; ++i) length += glm::distance(at(i), at(i + 1));
  return length;
}

}  // namespace

void addPatch(Mesh& mesh, const Surface& position, glm::ivec2 segments) {
  const glm::vec2 size(middleLength(position, segments.x, true), middleLength(position, segments.y, false));
  std::vector<GridPoint> points;
  for (int row = 0; row <= segments.y; ++row) {
    for (int column = 0; column <= segments.x; ++column) {
      const glm::vec2 at = glm::vec2(column, row) / glm::vec2(segments);
      points.push_back(
          {position(at.x, at.y), normalAt(position, at.x, at.y), {at.x * size.x, (1.0f - at.y) * size.y}});
    }
  }
  addGrid(mesh, points, segments.x + 1);
}

}  // namespace host::modelling
