#include "tests/support/synthetic_shadow.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace mres::test {
namespace {

constexpr double kFar = 40.0;

glm::dmat4 lookFrom(glm::dvec3 eye, glm::dvec3 target) {
  const glm::dvec3 direction = glm::normalize(target - eye);
  const glm::dvec3 up = std::abs(direction.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
  return glm::lookAt(eye, target, up);
}

/// The same scene, for rays in light space.
RayCaster inLightSpace(const RayCaster& scene, const glm::mat4& lightFromView) {
  const glm::dmat4 viewFromLight = glm::inverse(glm::dmat4(lightFromView));
  return [=](glm::dvec3 origin, glm::dvec3 direction) {
    return scene(glm::dvec3(viewFromLight * glm::dvec4(origin, 1.0)), glm::dmat3(viewFromLight) * direction);
  };
}

}  // namespace

SyntheticLight parallelLight(glm::dvec3 toLight, glm::dvec3 target, float extent) {
  const glm::dvec3 direction = glm::normalize(toLight);
  return {.lightFromView = lookFrom(target + direction * (0.5 * kFar), target),
          .projection = glm::ortho(-extent, extent, -extent, extent, 0.1f, static_cast<float>(kFar)),
          .light = glm::vec4(glm::vec3(direction), 0.0f)};
}

SyntheticLight spotLight(glm::dvec3 position, glm::dvec3 target) {
  return {.lightFromView = lookFrom(position, target),
          .projection = glm::perspective(glm::radians(90.0f), 1.0f, 0.1f, static_cast<float>(kFar)),
          .light = glm::vec4(glm::vec3(position), 1.0f)};
}

SyntheticShadow::SyntheticShadow(const RayCaster& scene, const SyntheticLight& light, glm::ivec2 size)
    : map_(size, light.projection, inLightSpace(scene, light.lightFromView)),
      inputs_{.shadowMap = map_.frame().depth,
              .mapSize = size,
              .shadowFromView = glm::translate(glm::mat4(1.0f), glm::vec3(0.5f)) *
                                glm::scale(glm::mat4(1.0f), glm::vec3(0.5f)) * light.projection *
                                light.lightFromView,
              .light = light.light} {}

double SyntheticShadow::depth(glm::ivec2 texel) const {
  const glm::ivec2 size = inputs_.mapSize;
  const glm::ivec2 inside = glm::clamp(texel, glm::ivec2(0), size - 1);
  return static_cast<double>(map_.depths().at(static_cast<std::size_t>(inside.y * size.x + inside.x)));
}

}  // namespace mres::test
