// Where the sun's shadow map lies: over what the camera sees of the scene, and over everything between that
// and the sun.
#pragma once

#include <optional>

#include "host/renderer/camera_view.h"
#include "host/renderer/shadow/shadow_view.h"

namespace host {

/// A square of the plane across the light, in metres along its axes, and a range of depths towards the sun.
struct ShadowFit {
  glm::dmat3 worldToLight{1.0};  ///< rotation; z points to the sun
  glm::dvec2 corner{0.0};
  double extent = 1.0;
  double farthest = 0.0;  ///< from the sun: the smallest z
  double nearest = 1.0;

  [[nodiscard]] ShadowView view(int mapSize) const;
};

/// What a shadow map is made for.
struct ShadowMapNeeds {
  int size = 2048;     ///< texels a side, at least 64
  float reach = 0.0f;  ///< metres across the light that filters see beyond a surface
};

/// Fits a map. It stands still under small movements of the camera: its size grows in steps, its corner moves
/// by whole texels, so that shadow edges don't shimmer. Nothing if the camera sees nothing of the scene.
std::optional<ShadowFit> fitShadow(const Camera& camera, const CameraView& view, float aspect,
                                   const Bounds& scene, glm::vec3 directionToSun, ShadowMapNeeds needs);

}  // namespace host
