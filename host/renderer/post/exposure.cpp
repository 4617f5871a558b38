#include "host/renderer/post/exposure.h"

#include <algorithm>
#include <glm/gtc/constants.hpp>

#include "host/renderer/lighting/light_set.h"

namespace host {
namespace {

/// The radiance of an average surface is shown as this: photographers' middle grey, a little raised, since
/// the rooms that are drawn here have light walls.
constexpr float kMiddleGrey = 0.3f;
constexpr float kAverageAlbedo = 0.5f;
/// The part of the surfaces that a directional light reaches: half face away, and much of the rest lies in
/// shadow.
constexpr float kSunlitShare = 0.15f;

/// What falls on an average surface; `area` is that of the surfaces around the scene.
float averageIlluminance(const Light& light, float area) {
  const float brightness = luminance(light.color) * light.intensity;
  if (light.type == LightType::directional) return brightness * kSunlitShare;
  const float solidAngle = light.type == LightType::point
                               ? 4.0f * glm::pi<float>()
                               : 2.0f * glm::pi<float>() * (1.0f - std::cos(light.outerConeAngle));
  return brightness * solidAngle / area;
}

}  // namespace

float exposureOf(const Scene& scene, const Bounds& bounds) {
  const glm::vec3 size = bounds.max - bounds.min;
  const float area = std::max(2.0f * (size.x * size.y + size.y * size.z + size.z * size.x), 1.0f);
  float illuminance = luminance(scene.ambient) * glm::pi<float>();
  for (const Light& light : scene.lights) illuminance += averageIlluminance(light, area);
  if (illuminance <= 0.0f) return 1.0f;  // only what shines by itself is seen: as it is
  return kMiddleGrey / (illuminance * kAverageAlbedo * glm::one_over_pi<float>());
}

}  // namespace host
