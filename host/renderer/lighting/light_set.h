#pragma once

#include <optional>
#include <vector>

#include "host/scene/scene.h"
#include "shaders/host/light_params.h"

namespace host {

/// The scene's lights by how they are drawn.
class LightSet {
 public:
  explicit LightSet(std::vector<Light> lights);

  /// The one that casts shadows: the brightest directional light or, without one, the brightest spot light.
  [[nodiscard]] std::optional<Light> shadowCaster() const;
  /// That one first, then the brightest ones first, no more than the shader takes.
  [[nodiscard]] const std::vector<Light>& lights() const { return lights_; }
  /// How many lights were left out for want of room.
  [[nodiscard]] std::size_t leftOut() const { return leftOut_; }

  /// Relative to `origin`.
  [[nodiscard]] mres::params::LightParams params(glm::vec3 origin) const;

 private:
  std::vector<Light> lights_;
  bool hasCaster_ = false;
  std::size_t leftOut_ = 0;
};

/// Luminance of linear sRGB colour (ITU-R BT.709).
inline float luminance(glm::vec3 color) {
  return glm::dot(color, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

}  // namespace host
