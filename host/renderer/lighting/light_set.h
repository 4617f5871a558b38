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

  /// The brightest directional light: the one that casts shadows.
  [[nodiscard]] const std::optional<Light>& sun() const { return sun_; }
  /// All others, the brightest ones first, no more than the shader takes.
  [[nodiscard]] const std::vector<Light>& others() const { return others_; }
  /// How many lights were left out for want of room.
  [[nodiscard]] std::size_t leftOut() const { return leftOut_; }

  /// The others, relative to `origin`.
  [[nodiscard]] mres::params::LightParams params(glm::vec3 origin) const;

 private:
  std::optional<Light> sun_;
  std::vector<Light> others_;
  std::size_t leftOut_ = 0;
};

/// Luminance of linear sRGB colour (ITU-R BT.709).
inline float luminance(glm::vec3 color) {
  return glm::dot(color, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

}  // namespace host
