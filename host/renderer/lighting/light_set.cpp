#include "host/renderer/lighting/light_set.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace host {
namespace {

float brightness(const Light& light) {
  return luminance(light.color) * light.intensity;
}

/// Scale and offset of the cosine between the cone's axis and a point, so that the share of light is 1 inside
/// of the inner cone and 0 outside of the outer one (KHR_lights_punctual, "Inner and Outer Cone Angles").
glm::vec2 coneOf(const Light& light) {
  if (light.type != LightType::spot) return {0.0f, 1.0f};
  const float outer = std::cos(light.outerConeAngle);
  const float scale = 1.0f / std::max(0.001f, std::cos(light.innerConeAngle) - outer);
  return {scale, -outer * scale};
}

float reachOf(const Light& light) {
  if (light.type == LightType::directional) return -1.0f;
  return light.range > 0.0f ? 1.0f / light.range : 0.0f;
}

glm::vec3 directionOf(const Light& light) {
  return light.type == LightType::point ? glm::vec3(0.0f, -1.0f, 0.0f) : glm::normalize(light.direction);
}

}  // namespace

LightSet::LightSet(std::vector<Light> lights) : lights_(std::move(lights)) {
  std::erase_if(lights_, [](const Light& light) { return brightness(light) <= 0.0f; });
  std::ranges::stable_sort(lights_, std::ranges::greater{}, brightness);
  for (const LightType type : {LightType::directional, LightType::spot}) {
    const auto caster = std::ranges::find(lights_, type, &Light::type);
    if (caster == lights_.end()) continue;
    std::rotate(lights_.begin(), caster, caster + 1);
    hasCaster_ = true;
    break;
  }
  if (lights_.size() > MAX_LIGHTS) {
    leftOut_ = lights_.size() - MAX_LIGHTS;
    lights_.resize(MAX_LIGHTS);
  }
}

std::optional<Light> LightSet::shadowCaster() const {
  return hasCaster_ ? std::optional(lights_.front()) : std::nullopt;
}

mres::params::LightParams LightSet::params(glm::vec3 origin) const {
  mres::params::LightParams params{};
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    const Light& light = lights_[i];
    const glm::vec2 cone = coneOf(light);
    params.lightPosition[i] = glm::vec4(light.position - origin, reachOf(light));
    params.lightIntensity[i] = glm::vec4(light.color * light.intensity, cone.x);
    params.lightDirection[i] = glm::vec4(directionOf(light), cone.y);
  }
  params.lightCount = static_cast<int>(lights_.size());
  params.shadowedLights = hasCaster_ ? 1 : 0;
  return params;
}

}  // namespace host
