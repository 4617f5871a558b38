#include "host/renderer/shadow/spot_view.h"

#include <algorithm>
#include <cmath>

#include "host/renderer/convex.h"

namespace host {
namespace {

/// Wider ones would spend the map on the cone's rim.
const double kWidestOpening = glm::radians(160.0);
/// More than the cone, so that filters find texels beyond its rim.
constexpr double kMargin = 1.05;
/// Nearer things cast no shadow; 24 bits of depth then tell a tenth of a millimetre from the other at a
/// metre.
constexpr double kNearOverFar = 1e-3;

double farthestAlong(glm::dvec3 axis, glm::dvec3 origin, const Bounds& scene) {
  double farthest = 0.0;
  for (const glm::vec3& corner : cornersOf(scene))
    farthest = std::max(farthest, glm::dot(glm::dvec3(corner) - origin, axis));
  return farthest;
}

}  // namespace

std::optional<ShadowView> spotView(const Light& light, const Bounds& scene, int mapSize) {
  const glm::dvec3 axis = glm::normalize(glm::dvec3(light.direction));
  const glm::dvec3 origin(light.position);
  double far = farthestAlong(axis, origin, scene) * kMargin;
  if (light.range > 0.0f) far = std::min(far, static_cast<double>(light.range));
  if (far <= 0.0) return std::nullopt;

  const double opening = std::min(2.0 * kMargin * static_cast<double>(light.outerConeAngle), kWidestOpening);
  const glm::dvec3 up = std::abs(axis.y) < 0.99 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
  return ShadowView{.clipFromWorld = glm::perspective(opening, 1.0, kNearOverFar * far, far) *
                                     glm::lookAt(origin, origin + axis, up),
                    .texelMetres = 2.0 * std::tan(0.5 * opening) / mapSize};
}

}  // namespace host
