#include "host/scene/clip_planes.h"

#include <algorithm>

namespace host {
namespace {

// 24 bits of depth resolve a hundredth of a percent of the distance at the far plane with this ratio.
constexpr float kNearToFar = 2e-4f;

}  // namespace

void fitClipPlanes(Camera& camera, const Bounds& bounds) {
  const glm::vec3 forward = camera.orientation * glm::vec3(0.0f, 0.0f, -1.0f);
  const glm::vec3 size = bounds.max - bounds.min;
  const float extent = std::max({size.x, size.y, size.z, 1e-6f});
  float nearest = 0.0f;
  float farthest = 0.0f;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 point((corner & 1) != 0 ? bounds.max.x : bounds.min.x,
                          (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                          (corner & 4) != 0 ? bounds.max.z : bounds.min.z);
    const float depth = glm::dot(point - camera.position, forward);
    nearest = corner == 0 ? depth : std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  const float margin = 0.01f * extent;
  camera.farPlane = std::max(farthest, extent) + margin;
  camera.nearPlane = std::max(nearest - margin, camera.farPlane * kNearToFar);
}

}  // namespace host
