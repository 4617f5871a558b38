#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace host {

/// A rotation that takes +Z to a unit vector (Duff et al. 2017, "Building an Orthonormal Basis, Revisited").
inline glm::mat3 frameAround(glm::vec3 axis) {
  const float sign = std::copysign(1.0f, axis.z);
  const float a = -1.0f / (sign + axis.z);
  const float b = axis.x * axis.y * a;
  return {glm::vec3(1.0f + sign * axis.x * axis.x * a, sign * b, -sign * axis.x),
          glm::vec3(b, sign + axis.y * axis.y * a, -axis.y), axis};
}

}  // namespace host
