#include <algorithm>
#include <vector>

#include "effects/common/sample_points.h"
#include "host/truth/ray_traced.h"
#include "host/truth/surface_frame.h"
#include "host/truth/surface_loop.h"

namespace host {

Truth traceAccessibility(const RayScene& scene, const GridSurfaces& surfaces, const OcclusionRays& rays,
                         const WorkObserver& observe) {
  const auto accessibility = [&](const SurfacePoint& surface, int index) {
    const glm::mat3 frame = frameAround(surface.normal);
    std::vector<glm::vec3> points = mres::hemispherePoints(kTruthRays, index);
    for (glm::vec3& point : points) point = frame * (rays.radius * point);
    const float occluded = static_cast<float>(scene.countBlocked(surface.origin, points)) / kTruthRays;
    return std::clamp(1.0f - rays.intensity * occluded, 0.0f, 1.0f);
  };
  return {"ray_traced", "rays", kTruthRays, surfaces.grid, evaluateEach(surfaces, accessibility, observe)};
}

}  // namespace host
