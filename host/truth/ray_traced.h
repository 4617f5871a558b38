#pragma once

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

/// The share of the sun's disk that each surface sees. As in the effect, those that face away from its
/// centre see nothing.
struct SunRays {
  glm::vec3 towardsSun{0.0f, 1.0f, 0.0f};  ///< world, unit length
  float diameter = 0.53f;                  ///< degrees in the sky
};
Truth traceSunVisibility(const RayScene& scene, const GridSurfaces& surfaces, const SunRays& rays,
                         const WorkObserver& observe);

}  // namespace host
