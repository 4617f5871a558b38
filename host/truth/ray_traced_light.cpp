#include <vector>

#include "effects/soft_shadows/disk_samples.h"
#include "host/truth/ray_traced.h"
#include "host/truth/surface_frame.h"
#include "host/truth/surface_loop.h"

namespace host {
namespace {

bool isInMap(const glm::mat4& mapFromWorld, glm::vec3 point) {
  const glm::vec4 clip = mapFromWorld * glm::vec4(point, 1.0f);
  const glm::vec3 window = glm::vec3(clip) / clip.w;
  return clip.w > 0.0f && glm::all(glm::greaterThanEqual(window, glm::vec3(0.0f))) &&
         glm::all(glm::lessThanEqual(window, glm::vec3(1.0f)));
}

/// From a surface to points of the light's disk, or to beyond the scene towards them.
std::vector<glm::vec3> segmentsTo(const LightRays& light, const RayScene& scene, glm::vec3 origin, int seed) {
  const bool parallel = light.place.w == 0.0f;
  const glm::vec3 axis = parallel ? glm::vec3(light.place) : glm::vec3(light.place) - origin;
  const glm::mat3 frame = frameAround(glm::normalize(axis));
  std::vector<glm::vec3> segments;
  segments.reserve(kTruthRays);
  for (const glm::vec2 sample : mres::diskSamples(kTruthRays, seed)) {
    const glm::vec3 segment = axis + frame * glm::vec3(light.extent * sample, 0.0f);
    segments.push_back(parallel ? segment * scene.diameter() : segment);
  }
  return segments;
}

}  // namespace

Truth traceVisibility(const RayScene& scene, const GridSurfaces& surfaces, const LightRays& light,
                      const WorkObserver& observe) {
  const auto visibility = [&](const SurfacePoint& surface, int index) {
    const glm::vec3 towards = glm::vec3(light.place) - light.place.w * surface.origin;
    if (glm::dot(towards, surface.normal) <= 0.0f) return 0.0f;
    if (light.mapFromWorld && !isInMap(*light.mapFromWorld, surface.origin)) return 1.0f;
    const std::vector<glm::vec3> segments = segmentsTo(light, scene, surface.origin, index);
    return 1.0f - static_cast<float>(scene.countBlocked(surface.origin, segments)) / kTruthRays;
  };
  return {"ray_traced", "rays", kTruthRays, surfaces.grid, evaluateEach(surfaces, visibility, observe)};
}

}  // namespace host
