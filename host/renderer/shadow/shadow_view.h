#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace host {

/// What a shadow map sees of the world.
struct ShadowView {
  glm::dmat4 clipFromWorld{1.0};
  double texelMetres = 0.0;  ///< side of a texel where clip w is 1: everywhere in parallel light

  /// From the world relative to `origin`.
  [[nodiscard]] glm::mat4 clipMatrix(glm::vec3 origin) const {
    return {glm::translate(clipFromWorld, glm::dvec3(origin))};
  }

  bool operator==(const ShadowView&) const = default;
};

}  // namespace host
