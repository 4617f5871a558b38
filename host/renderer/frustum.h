#pragma once

#include <array>

#include "host/scene/scene.h"

namespace host {

/// The six half-spaces of a projection, for culling (Gribb and Hartmann 2001, "Fast extraction of viewing
/// frustum planes from the world-view-projection matrix").
class Frustum {
 public:
  explicit Frustum(const glm::mat4& worldToClip);

  /// False only for boxes that are wholly outside of one plane.
  [[nodiscard]] bool mayIntersect(const Bounds& box) const;

  /// Half-spaces: dot(plane, (p, 1)) >= 0 inside. Not normalised.
  [[nodiscard]] const std::array<glm::vec4, 6>& planes() const { return planes_; }

 private:
  std::array<glm::vec4, 6> planes_;
};

/// Bounds of a transformed box (Arvo 1990, "Transforming axis-aligned bounding boxes").
Bounds transformed(const Bounds& box, const glm::mat4& transform);

/// A box moved by `offset`.
inline Bounds moved(const Bounds& box, glm::vec3 offset) {
  return {box.min + offset, box.max + offset};
}

}  // namespace host
