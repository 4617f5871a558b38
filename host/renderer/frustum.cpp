#include "host/renderer/frustum.h"

namespace host {

Frustum::Frustum(const glm::mat4& worldToClip) {
  const glm::mat4 rows = glm::transpose(worldToClip);
  for (int axis = 0; axis < 3; ++axis) {
    planes_.at(static_cast<std::size_t>(axis) * 2) = rows[3] + rows[axis];
    planes_.at(static_cast<std::size_t>(axis) * 2 + 1) = rows[3] - rows[axis];
  }
}

bool Frustum::mayIntersect(const Bounds& box) const {
  for (const glm::vec4& plane : planes_) {
    // The corner that lies furthest inside.
    const glm::vec3 corner =
        glm::mix(box.min, box.max, glm::greaterThanEqual(glm::vec3(plane), glm::vec3(0.0f)));
    if (glm::dot(glm::vec3(plane), corner) + plane.w < 0.0f) return false;
  }
  return true;
}

Bounds transformed(const Bounds& box, const glm::mat4& transform) {
  const glm::vec3 translation(transform[3]);
  Bounds result{translation, translation};
  for (int axis = 0; axis < 3; ++axis) {
    const glm::vec3 a = glm::vec3(transform[axis]) * box.min[axis];
    const glm::vec3 b = glm::vec3(transform[axis]) * box.max[axis];
    result.min += glm::min(a, b);
    result.max += glm::max(a, b);
  }
  return result;
}

}  // namespace host
