#include "host/scene/auto_cameras.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include "host/scene/clip_planes.h"
#include "host/scene/interior.h"
#include "host/scene/surface_sampler.h"
#include "host/scene/triangle_grid.h"
#include "host/scene/view_score.h"

namespace host {
namespace {

constexpr int kCameras = 8;
constexpr float kInteriorShare = 0.25f;  // of the space next to surfaces
constexpr float kInteriorFov = 65.0f;    // degrees; wide, as rooms are photographed
constexpr float kObjectFov = 40.0f;

glm::vec3 headingOf(float azimuth, float elevation) {
  return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
          std::cos(elevation) * std::cos(azimuth)};
}

/// Around and somewhat above: from next to the ground to a bird's view.
std::vector<glm::vec3> outsideHeadings() {
  constexpr int kAzimuths = 16;
  std::vector<glm::vec3> headings;
  for (const float elevation : {4.0f, 16.0f, 32.0f, 55.0f}) {
    for (int i = 0; i < kAzimuths; ++i) {
      const float azimuth = (float(i) + 0.3f) * glm::two_pi<float>() / kAzimuths;
      headings.push_back(headingOf(azimuth, glm::radians(elevation)));
    }
  }
  return headings;
}

std::vector<Camera> interiorViews(const std::vector<glm::vec3>& places) {
  constexpr int kHeadings = 8;
  std::vector<Camera> candidates;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (int heading = 0; heading < kHeadings; ++heading) {
      const float azimuth =
          (float(heading) + radicalInverse(2, int(i) + 1)) * glm::two_pi<float>() / kHeadings;
      const float elevation = glm::radians(heading % 2 == 0 ? -12.0f : -2.0f);
      candidates.push_back(
          lookAt("inside", places[i], places[i] + headingOf(azimuth, elevation), kInteriorFov));
    }
  }
  return candidates;
}

/// The box of what matters: outlying ground and sky are cut away, a mast is not.
Bounds focusOf(const TriangleGrid& grid, const SurfaceSampler& sampler) {
  constexpr int kSamples = 2000;
  constexpr std::size_t kCut = kSamples / 50;
  constexpr float kOutlying = 2.5f;
  Bounds focus = grid.bounds();
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<float> values;
    values.reserve(kSamples);
    for (int i = 0; i < kSamples; ++i) values.push_back(sampler.sample(i).position[axis]);
    std::sort(values.begin(), values.end());
    const float low = values[kCut];
    const float high = values[kSamples - 1 - kCut];
    if (focus.max[axis] - focus.min[axis] > kOutlying * (high - low)) {
      focus.min[axis] = low;
      focus.max[axis] = high;
    }
  }
  return focus;
}

/// Views towards the centre from far enough to see everything.
std::vector<Camera> wholeViews(const Bounds& focus) {
  const glm::vec3 centre = (focus.min + focus.max) * 0.5f;
  const float radius = std::max(glm::length(focus.max - focus.min) * 0.5f, 1e-6f);
  const float distance = 0.8f * radius / std::sin(glm::radians(kObjectFov) * 0.5f);
  std::vector<Camera> candidates;
  for (const glm::vec3 heading : outsideHeadings()) {
    candidates.push_back(lookAt("whole", centre + heading * distance, centre, kObjectFov));
  }
  return candidates;
}

/// Closer views towards points on the surface.
std::vector<Camera> detailViews(const Bounds& focus, const SurfaceSampler& sampler) {
  const float distance = std::max(0.45f * glm::length(focus.max - focus.min), 1e-6f);
  std::vector<Camera> candidates;
  for (const glm::vec3 heading : outsideHeadings()) {
    const auto sample = sampler.sample(int(candidates.size()));
    const glm::vec3 target = glm::clamp(sample.position, focus.min, focus.max);
    candidates.push_back(lookAt("detail", target + heading * distance, target, kObjectFov));
  }
  return candidates;
}

/// 0 for the same view, towards 1 for one from elsewhere or in another direction.
float difference(const Camera& a, const Camera& b, float scale) {
  const float distance = glm::length(a.position - b.position) / scale;
  const float angle = 2.0f * std::acos(std::min(std::abs(glm::dot(a.orientation, b.orientation)), 1.0f));
  return 1.0f - std::exp(-(distance * distance + angle * angle * 2.0f));
}

/// Adds `count` cameras: greedily, the best view that differs from those chosen before.
void chooseBest(const TriangleGrid& grid, const std::vector<Camera>& candidates, int count, float scale,
                std::vector<Camera>& chosen) {
  std::vector<float> scores;
  for (const Camera& candidate : candidates) {
    float score = viewScore(grid, candidate, scale) + 1e-6f;  // a view of nothing is still better than none
    for (const Camera& other : chosen) score *= difference(candidate, other, scale);
    scores.push_back(score);
  }
  for (int i = 0; i < count; ++i) {
    const auto best = std::size_t(std::max_element(scores.begin(), scores.end()) - scores.begin());
    chosen.push_back(candidates[best]);
    for (std::size_t j = 0; j < candidates.size(); ++j) {
      scores[j] *= difference(candidates[j], chosen.back(), scale);
    }
  }
}

}  // namespace

std::vector<Camera> automaticCameras(const Scene& scene) {
  if (triangleCount(scene) == 0) return {lookAt("front", {0.0f, 0.0f, 2.0f}, glm::vec3(0.0f), kObjectFov)};
  const TriangleGrid grid(scene);
  const SurfaceSampler sampler(grid);
  const Bounds focus = focusOf(grid, sampler);
  const Interior interior = findInterior(grid, sampler);
  const float scale = std::max(0.25f * glm::length(focus.max - focus.min), 1e-6f);
  std::vector<Camera> cameras;
  if (interior.share > kInteriorShare && interior.places.size() >= kCameras) {
    chooseBest(grid, interiorViews(interior.places), kCameras, scale, cameras);
  } else {
    chooseBest(grid, wholeViews(focus), kCameras / 2, 4.0f * scale, cameras);
    chooseBest(grid, detailViews(focus, sampler), kCameras - kCameras / 2, 2.0f * scale, cameras);
  }
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    cameras[i].name = fmt::format("{} {}", cameras[i].name, i + 1);
    fitClipPlanes(cameras[i], boundsOf(scene));
  }
  return cameras;
}

}  // namespace host
