#include <cmath>
#include <vector>

#include "effects/soft_shadows/disk_samples.h"
#include "host/truth/ray_traced.h"
#include "host/truth/surface_frame.h"
#include "host/truth/surface_loop.h"

namespace host {

Truth traceSunVisibility(const RayScene& scene, const GridSurfaces& surfaces, const SunRays& rays,
                         const WorkObserver& observe) {
  const glm::mat3 frame = frameAround(rays.towardsSun);
  const float spread = std::tan(glm::radians(0.5f * rays.diameter));
  const auto visibility = [&](const SurfacePoint& surface, int index) {
    if (glm::dot(rays.towardsSun, surface.normal) <= 0.0f) return 0.0f;
    std::vector<glm::vec3> segments;
    segments.reserve(kTruthRays);
    for (const glm::vec2 sample : mres::diskSamples(kTruthRays, index))
      segments.push_back(frame * glm::vec3(spread * sample, 1.0f) * scene.diameter());
    return 1.0f - static_cast<float>(scene.countBlocked(surface.origin, segments)) / kTruthRays;
  };
  return {"ray_traced", "rays", kTruthRays, surfaces.grid, evaluateEach(surfaces, visibility, observe)};
}

}  // namespace host
