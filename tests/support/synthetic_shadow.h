#pragma once

#include "effects/soft_shadows/soft_shadows.h"
#include "tests/support/synthetic_gbuffer.h"

namespace mres::test {

/// A light that a shadow map belongs to, in view space.
struct SyntheticLight {
  glm::mat4 lightFromView{1.0f};  ///< the light looks along its own -Z
  glm::mat4 projection{1.0f};
  glm::vec4 light{0.0f};  ///< ShadowInputs::light
};

/// Parallel light from a direction, over everything within `extent` metres of `target` across the light.
SyntheticLight parallelLight(glm::dvec3 toLight, glm::dvec3 target, float extent);

/// A spot light of 90 degrees.
SyntheticLight spotLight(glm::dvec3 position, glm::dvec3 target);

/// The shadow map of a scene, cast in double precision from the light.
class SyntheticShadow {
 public:
  SyntheticShadow(const RayCaster& scene, const SyntheticLight& light, glm::ivec2 size);
  [[nodiscard]] const ShadowInputs& inputs() const { return inputs_; }
  /// The depth of a texel.
  [[nodiscard]] double depth(glm::ivec2 texel) const;

 private:
  SyntheticGBuffer map_;
  ShadowInputs inputs_;
};

}  // namespace mres::test
