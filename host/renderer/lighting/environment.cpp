#include "host/renderer/lighting/environment.h"

#include "host/renderer/lighting/light_set.h"

namespace host {
namespace {

/// How much of the sky's own gradient the ambient light takes on; the rest is even. Light that has been
/// reflected about a room a few times has lost most of its direction and colour.
constexpr float kTint = 0.35f;

}  // namespace

mres::params::EnvironmentParams environmentParams(const Scene& scene) {
  const Sky& sky = scene.sky;
  const glm::vec3 above = (sky.zenith + sky.horizon) * 0.5f;
  const float mean = luminance(above + sky.ground) * 0.5f;
  const auto ambientFrom = [&](glm::vec3 side) {
    const glm::vec3 tint = mean > 0.0f ? glm::mix(glm::vec3(1.0f), side / mean, kTint) : glm::vec3(1.0f);
    return glm::vec4(scene.ambient * tint, 0.0f);
  };
  mres::params::EnvironmentParams params{};
  params.skyZenith = glm::vec4(sky.zenith * sky.intensity, 0.0f);
  params.skyHorizon = glm::vec4(sky.horizon * sky.intensity, 0.0f);
  params.skyGround = glm::vec4(sky.ground * sky.intensity, 0.0f);
  params.ambientAbove = ambientFrom(above);
  params.ambientBelow = ambientFrom(sky.ground);
  return params;
}

}  // namespace host
