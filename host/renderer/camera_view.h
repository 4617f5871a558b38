// A camera's matrices, with the camera as the origin: what the passes draw with.
#pragma once

#include "host/renderer/frustum.h"
#include "host/scene/scene.h"
#include "shaders/host/view_params.h"

namespace host {

struct CameraView {
  CameraView(const Camera& camera, glm::ivec2 size);

  /// A position in the world, relative to the camera.
  [[nodiscard]] glm::vec3 relative(glm::vec3 world) const { return world - origin; }
  [[nodiscard]] mres::params::ViewParams params() const;
  [[nodiscard]] Frustum frustum() const { return Frustum(worldToClip); }

  glm::vec3 origin{0.0f};       ///< the camera's position in the world
  glm::mat4 rotation{1.0f};     ///< camera-relative world to view
  glm::mat4 projection{1.0f};   ///< view to clip
  glm::mat4 worldToClip{1.0f};  ///< from the camera-relative world
  glm::vec3 forward{0.0f, 0.0f, -1.0f};
  bool orthographic = false;
};

}  // namespace host
