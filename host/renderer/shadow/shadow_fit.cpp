#include "host/renderer/shadow/shadow_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/renderer/convex.h"

namespace host {
namespace {

/// Texels beyond what is seen on each side: the reach of the host's own filter
/// (shaders/host/shadow_lookup.glsl) and of its shift along the normal, and one for snapping.
constexpr double kMarginTexels = 8.0;
/// The size of the map grows by this factor at a time.
constexpr double kExtentStep = 1.125;

struct LightBounds {
  glm::dvec3 min{std::numeric_limits<double>::max()};
  glm::dvec3 max{std::numeric_limits<double>::lowest()};
  void add(glm::dvec3 point) {
    min = glm::min(min, point);
    max = glm::max(max, point);
  }
};

glm::dmat3 lightRotation(glm::vec3 directionToSun) {
  const glm::dvec3 z = glm::normalize(glm::dvec3(directionToSun));
  const glm::dvec3 helper = std::abs(z.y) < 0.99 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 x = glm::normalize(glm::cross(helper, z));
  return glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
}

/// Corners of what the camera sees up to `farDistance`, relative to the camera.
Corners frustumCorners(const Camera& camera, const CameraView& view, float aspect, float farDistance) {
  const glm::mat3 viewToWorld = glm::transpose(glm::mat3(view.rotation));
  Corners corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const float distance = (i & 4U) != 0U ? farDistance : camera.nearPlane;
    const float halfHeight = camera.orthographicHeight ? *camera.orthographicHeight * 0.5f
                                                       : std::tan(camera.verticalFov * 0.5f) * distance;
    const glm::vec2 side((i & 1U) != 0U ? 1.0f : -1.0f, (i & 2U) != 0U ? 1.0f : -1.0f);
    corners[i] = viewToWorld * glm::vec3(side * glm::vec2(halfHeight * aspect, halfHeight), -distance);
  }
  return corners;
}

/// How far the scene reaches in front of the camera.
float farthestDistance(const Camera& camera, const CameraView& view, const Corners& scene) {
  float distance = camera.nearPlane;
  for (const glm::vec3& corner : scene) distance = glm::max(distance, glm::dot(corner, view.forward));
  return camera.farPlane > 0.0f ? glm::min(distance, camera.farPlane) : distance;
}

LightBounds boundsInLight(std::span<const glm::vec3> points, const glm::dmat3& worldToLight,
                          glm::dvec3 origin) {
  LightBounds bounds;
  for (const glm::vec3& point : points) bounds.add(worldToLight * (glm::dvec3(point) + origin));
  return bounds;
}

}  // namespace

ShadowView ShadowFit::view(int mapSize) const {
  const glm::dvec3 centre(corner + extent * 0.5, (nearest + farthest) * 0.5);
  const glm::dvec3 scale(2.0 / extent, 2.0 / extent, -2.0 / (nearest - farthest));  // the sun's side is near
  glm::dmat4 matrix(1.0);
  for (int column = 0; column < 3; ++column) matrix[column] = glm::dvec4(worldToLight[column] * scale, 0.0);
  matrix[3] = glm::dvec4(-centre * scale, 1.0);
  return {.clipFromWorld = matrix, .texelMetres = extent / mapSize};
}

std::optional<ShadowFit> fitShadow(const Camera& camera, const CameraView& view, float aspect,
                                   const Bounds& scene, glm::vec3 directionToSun, ShadowMapNeeds needs) {
  const Bounds box = moved(scene, -view.origin);
  const Corners boxCorners = cornersOf(box);
  const Corners seen = frustumCorners(camera, view, aspect, farthestDistance(camera, view, boxCorners));
  const std::vector<glm::vec3> receivers =
      intersectionPoints(boxCorners, planesOf(box), seen, view.frustum().planes());
  if (receivers.empty()) return std::nullopt;

  ShadowFit fit{.worldToLight = lightRotation(directionToSun)};
  const glm::dvec3 origin(view.origin);
  const LightBounds receiverBounds = boundsInLight(receivers, fit.worldToLight, origin);
  const LightBounds casterBounds = boundsInLight(cornersOf(scene), fit.worldToLight, glm::dvec3(0.0));

  const glm::dvec2 needed(receiverBounds.max - receiverBounds.min);
  const double inner = std::max({needed.x, needed.y, 1e-3}) + 2.0 * static_cast<double>(needs.reach);
  const double stepped = std::pow(kExtentStep, std::ceil(std::log(inner) / std::log(kExtentStep)));
  const double texel = stepped / (needs.size - 2.0 * kMarginTexels);
  fit.extent = texel * needs.size;
  const glm::dvec2 centred = glm::dvec2(receiverBounds.min) + (needed - fit.extent) * 0.5;
  fit.corner = glm::round(centred / texel) * texel;

  const double margin = kMarginTexels * texel;
  // The whole scene's depths, since these stay the same wherever the camera is.
  fit.nearest = casterBounds.max.z + margin;
  fit.farthest = casterBounds.min.z - margin;
  return fit;
}

}  // namespace host
