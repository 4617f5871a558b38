#pragma once

#include <optional>

#include "host/truth/grid_surfaces.h"
#include "host/truth/ray_scene.h"
#include "host/truth/truth.h"
#include "host/truth/work_observer.h"

namespace host {

inline constexpr int kTruthRays = 256;  ///< for each pixel

/// Ambient occlusion by the effect's own points in the hemisphere, each with a ray to it through the scene's
/// real geometry in place of a look at the depth buffer.
struct OcclusionRays {
  float radius = 0.5f;     ///< metres
  float intensity = 1.0f;  ///< multiplies the occlusion
};
Truth traceAccessibility(const RayScene& scene, const GridSurfaces& surfaces, const OcclusionRays& rays,
                         const WorkObserver& observe);

/// The share of a light's disk that each surface sees. As in the effect, surfaces that face away from its
/// centre see nothing of it, and those that its shadow map does not cover see all.
struct LightRays {
  /// World: unit direction to a parallel light and 0, or a lamp's position and 1. A lamp's disk faces the
  /// surface, as a sphere's does.
  glm::vec4 place{0.0f, 1.0f, 0.0f, 0.0f};
  float extent =
      0.0046f;  ///< tangent of half of a parallel light's angle in the sky; a lamp's radius in metres
  std::optional<glm::mat4> mapFromWorld = {};  ///< to 0..1 after division by w; none: it covers everything
};
Truth traceVisibility(const RayScene& scene, const GridSurfaces& surfaces, const LightRays& light,
                      const WorkObserver& observe);

}  // namespace host
