#include "host/scene/auto_cameras.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <numeric>

#include "host/scene/clip_planes.h"
#include "host/scene/triangle_grid.h"
#include "host/scene/view_score.h"

namespace host {
namespace {

constexpr int kCameras = 8;
constexpr float kInteriorFov = 65.0f;  // degrees; wide, as rooms are photographed
constexpr float kObjectFov = 40.0f;

/// A number in 0..1 from a low-discrepancy sequence: evenly spread, and the same in every run.
float radicalInverse(int base, int i) {
  float result = 0.0f;
  float digit = 1.0f / float(base);
  for (; i > 0; i /= base, digit /= float(base)) result += float(i % base) * digit;
  return result;
}

/// Unit vectors spread evenly over the sphere (spherical Fibonacci).
glm::vec3 sphereDirection(int i, int count) {
  const float y = 1.0f - (2.0f * float(i) + 1.0f) / float(count);
  const float radius = std::sqrt(std::max(1.0f - y * y, 0.0f));
  const float azimuth = float(i) * glm::pi<float>() * (3.0f - std::sqrt(5.0f));
  return {radius * std::cos(azimuth), y, radius * std::sin(azimuth)};
}

glm::vec3 headingOf(float azimuth, float elevation) {
  return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
          std::cos(elevation) * std::cos(azimuth)};
}

/// Points on the surfaces with their normals. A triangle's weight is the root of its area: by area alone a
/// huge ground would get all points, by number alone a detailed plant would.
class SurfaceSampler {
 public:
  explicit SurfaceSampler(const TriangleGrid& grid) : triangles_(grid.triangles()) {
    cumulativeWeights_.reserve(triangles_.size());
    double sum = 0.0;
    for (const WorldTriangle& triangle : triangles_) {
      sum += std::sqrt(glm::length(areaNormal(triangle)));
      cumulativeWeights_.push_back(sum);
    }
  }

  struct Sample {
    glm::vec3 position;
    glm::vec3 normal;
  };

  Sample sample(int i) const {
    const double target = double(radicalInverse(2, i + 1)) * cumulativeWeights_.back();
    const auto found = std::upper_bound(cumulativeWeights_.begin(), cumulativeWeights_.end(), target);
    const auto index = std::min(std::size_t(found - cumulativeWeights_.begin()), triangles_.size() - 1);
    const WorldTriangle& triangle = triangles_[index];
    const float root = std::sqrt(radicalInverse(3, i + 1));
    const float v = radicalInverse(5, i + 1);
    const auto& [a, b, c] = triangle.corners;
    const glm::dvec3 normal = areaNormal(triangle);
    const double length = glm::length(normal);
    return {a * (1.0f - root) + b * (root * (1.0f - v)) + c * (root * v),
            length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f, 1.0f, 0.0f)};
  }

 private:
  static glm::dvec3 areaNormal(const WorldTriangle& triangle) {
    const glm::dvec3 origin(triangle.corners[0]);
    return glm::cross(glm::dvec3(triangle.corners[1]) - origin, glm::dvec3(triangle.corners[2]) - origin);
  }

  const std::vector<WorldTriangle>& triangles_;
  std::vector<double> cumulativeWeights_;
};

/// What surrounds a point.
struct Surroundings {
  float hitShare = 0.0f;   ///< of all directions in which there is something
  float backShare = 0.0f;  ///< of the hits, on the inside of something solid
  float clearance = 0.0f;  ///< distance to the nearest hit
};

Surroundings surroundingsOf(const TriangleGrid& grid, glm::vec3 point) {
  constexpr int kDirections = 48;
  int hits = 0;
  int backFaces = 0;
  float clearance = glm::length(grid.bounds().max - grid.bounds().min);
  for (int i = 0; i < kDirections; ++i) {
    const auto hit = grid.trace(point, sphereDirection(i, kDirections));
    if (!hit) continue;
    ++hits;
    backFaces += hit->isBackFace ? 1 : 0;
    clearance = std::min(clearance, hit->distance);
  }
  return {float(hits) / kDirections, hits > 0 ? float(backFaces) / float(hits) : 0.0f, clearance};
}

/// Between floor and ceiling at about the height of eyes in a room.
glm::vec3 atEyeLevel(const TriangleGrid& grid, glm::vec3 point, float relativeHeight) {
  const auto floor = grid.trace(point, {0.0f, -1.0f, 0.0f});
  const auto ceiling = grid.trace(point, {0.0f, 1.0f, 0.0f});
  if (!floor || !ceiling) return point;
  point.y += (floor->distance + ceiling->distance) * relativeHeight - floor->distance;
  return point;
}

/// Places to stand inside of rooms, and how much of the space is rooms.
struct Interior {
  std::vector<glm::vec3> places;
  float share = 0.0f;
};

Interior findInterior(const TriangleGrid& grid, const SurfaceSampler& sampler) {
  constexpr int kSamples = 400;
  constexpr std::size_t kPlaces = 60;
  constexpr float kEnclosed = 0.75f;  // an atrium or a room with a missing wall still counts
  struct Place {
    glm::vec3 position;
    float clearance;
  };
  const float step = 1e-5f * glm::length(grid.bounds().max - grid.bounds().min);  // off the surface
  std::vector<Place> places;
  int solid = 0;
  for (int i = 0; i < kSamples; ++i) {
    const auto [position, normal] = sampler.sample(i);
    const auto opposite = grid.trace(position + normal * step, normal);
    if (!opposite) continue;
    const float relativeHeight = 0.35f + 0.3f * radicalInverse(7, i + 1);
    const glm::vec3 middle =
        position + normal * (opposite->distance * (0.3f + 0.4f * radicalInverse(11, i + 1)));
    const glm::vec3 place = atEyeLevel(grid, middle, relativeHeight);
    const Surroundings surroundings = surroundingsOf(grid, place);
    if (surroundings.backShare > 0.1f) {
      ++solid;
    } else if (surroundings.hitShare >= kEnclosed) {
      places.push_back({place, surroundings.clearance});
    }
  }
  Interior interior;
  interior.share = float(places.size()) / float(std::max(kSamples - solid, 1));
  // The widest places: nobody takes a room's picture from inside of a cupboard.
  std::sort(places.begin(), places.end(),
            [](const Place& a, const Place& b) { return a.clearance > b.clearance; });
  places.resize(std::min(places.size(), kPlaces));
  for (const Place& place : places) interior.places.push_back(place.position);
  return interior;
}

std::vector<Camera> interiorCandidates(const std::vector<glm::vec3>& places) {
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

/// The box of what matters: outlying ground and sky are cut away.
Bounds focusOf(const SurfaceSampler& sampler) {
  constexpr int kSamples = 2000;
  constexpr std::size_t kCut = kSamples / 50;
  std::array<std::vector<float>, 3> coordinates;
  for (int i = 0; i < kSamples; ++i) {
    const glm::vec3 position = sampler.sample(i).position;
    for (int axis = 0; axis < 3; ++axis) coordinates[std::size_t(axis)].push_back(position[axis]);
  }
  Bounds focus;
  for (int axis = 0; axis < 3; ++axis) {
    auto& values = coordinates[std::size_t(axis)];
    std::sort(values.begin(), values.end());
    focus.min[axis] = values[kCut];
    focus.max[axis] = values[kSamples - 1 - kCut];
  }
  return focus;
}

std::vector<Camera> objectCandidates(const Bounds& focus) {
  constexpr int kAzimuths = 16;
  const glm::vec3 centre = (focus.min + focus.max) * 0.5f;
  const float radius = std::max(glm::length(focus.max - focus.min) * 0.5f, 1e-6f);
  const float fitting = radius / std::sin(glm::radians(kObjectFov) * 0.5f);
  std::vector<Camera> candidates;
  for (const float elevation : {4.0f, 16.0f, 32.0f, 55.0f}) {
    for (int i = 0; i < kAzimuths; ++i) {
      const float azimuth = (float(i) + 0.3f) * glm::two_pi<float>() / kAzimuths;
      const glm::vec3 heading = headingOf(azimuth, glm::radians(elevation));
      for (const float distance : {0.85f, 0.5f}) {
        candidates.push_back(lookAt("outside", centre + heading * (fitting * distance), centre, kObjectFov));
      }
    }
  }
  return candidates;
}

/// 0 for the same view, towards 1 for one from elsewhere or in another direction.
float difference(const Camera& a, const Camera& b, float scale) {
  const float distance = glm::length(a.position - b.position) / scale;
  const float angle = 2.0f * std::acos(std::min(std::abs(glm::dot(a.orientation, b.orientation)), 1.0f));
  return 1.0f - std::exp(-(distance * distance + angle * angle * 2.0f));
}

/// Greedily, the best view that differs from those chosen before.
std::vector<Camera> chooseBest(const TriangleGrid& grid, const std::vector<Camera>& candidates, float scale) {
  std::vector<float> scores(candidates.size());
  std::transform(candidates.begin(), candidates.end(), scores.begin(),
                 // Views that see nothing are still better than no views.
                 [&grid](const Camera& camera) { return viewScore(grid, camera) + 1e-6f; });
  std::vector<Camera> chosen;
  while (chosen.size() < kCameras && chosen.size() < candidates.size()) {
    const auto best = std::size_t(std::max_element(scores.begin(), scores.end()) - scores.begin());
    chosen.push_back(candidates[best]);
    for (std::size_t i = 0; i < candidates.size(); ++i)
      scores[i] *= difference(candidates[i], chosen.back(), scale);
  }
  return chosen;
}

}  // namespace

std::vector<Camera> automaticCameras(const Scene& scene) {
  if (triangleCount(scene) == 0) return {lookAt("front", {0.0f, 0.0f, 2.0f}, glm::vec3(0.0f), kObjectFov)};
  const TriangleGrid grid(scene);
  const SurfaceSampler sampler(grid);
  const Bounds focus = focusOf(sampler);
  const Interior interior = findInterior(grid, sampler);
  const bool isInterior = interior.share > 0.25f && interior.places.size() >= kCameras;
  const float scale = 0.25f * glm::length(focus.max - focus.min);
  std::vector<Camera> cameras =
      chooseBest(grid, isInterior ? interiorCandidates(interior.places) : objectCandidates(focus),
                 std::max(scale, 1e-6f));
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    cameras[i].name = fmt::format("{} {}", cameras[i].name, i + 1);
    fitClipPlanes(cameras[i], boundsOf(scene));
  }
  return cameras;
}

}  // namespace host
