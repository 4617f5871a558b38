#include "host/scene/interior.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <optional>

namespace host {
namespace {

/// Unit vectors spread evenly over the sphere (spherical Fibonacci).
glm::vec3 sphereDirection(int i, int count) {
  const float y = 1.0f - (2.0f * float(i) + 1.0f) / float(count);
  const float radius = std::sqrt(std::max(1.0f - y * y, 0.0f));
  const float azimuth = float(i) * glm::pi<float>() * (3.0f - std::sqrt(5.0f));
  return {radius * std::cos(azimuth), y, radius * std::sin(azimuth)};
}

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

/// Between floor and ceiling at about the height of eyes in a room; nothing where nobody could stand: glTF is
/// in metres, and the inside of a cup is no room.
std::optional<glm::vec3> atEyeLevel(const TriangleGrid& grid, glm::vec3 point, float relativeHeight) {
  constexpr float kLowestCeiling = 1.2f;
  constexpr float kHighestEyes = 2.5f;
  const auto floor = grid.trace(point, {0.0f, -1.0f, 0.0f});
  const auto ceiling = grid.trace(point, {0.0f, 1.0f, 0.0f});
  if (!floor) return std::nullopt;
  const float height = ceiling ? floor->distance + ceiling->distance : std::numeric_limits<float>::infinity();
  if (height < kLowestCeiling) return std::nullopt;
  const float eyes = std::min(height * relativeHeight, std::max(kHighestEyes, floor->distance));
  point.y += eyes - floor->distance;
  return point;
}

struct Place {
  glm::vec3 position;
  float clearance;
};

/// The widest places that are not next to each other: nobody photographs a room from inside of a cupboard.
std::vector<glm::vec3> thinnedOut(std::vector<Place> places) {
  constexpr std::size_t kPlaces = 48;
  std::sort(places.begin(), places.end(),
            [](const Place& a, const Place& b) { return a.clearance > b.clearance; });
  std::vector<glm::vec3> kept;
  for (const Place& place : places) {
    if (kept.size() == kPlaces) break;
    const bool isNew = std::all_of(kept.begin(), kept.end(), [&place](glm::vec3 other) {
      return glm::length(place.position - other) > 0.4f * place.clearance;
    });
    if (isNew) kept.push_back(place.position);
  }
  return kept;
}

}  // namespace

Interior findInterior(const TriangleGrid& grid, const SurfaceSampler& sampler) {
  constexpr int kSamples = 800;
  constexpr float kEnclosed = 0.75f;  // an atrium or a room with a missing wall still counts
  const float step = 1e-5f * glm::length(grid.bounds().max - grid.bounds().min);  // off the surface
  std::vector<Place> places;
  int solid = 0;
  for (int i = 0; i < kSamples; ++i) {
    const auto [position, normal] = sampler.sample(i);
    const auto opposite = grid.trace(position + normal * step, normal);
    if (!opposite) continue;
    const glm::vec3 middle =
        position + normal * (opposite->distance * (0.3f + 0.4f * radicalInverse(11, i + 1)));
    const auto place = atEyeLevel(grid, middle, 0.35f + 0.3f * radicalInverse(7, i + 1));
    if (!place) continue;
    const Surroundings surroundings = surroundingsOf(grid, *place);
    if (surroundings.backShare > 0.1f) {
      ++solid;
    } else if (surroundings.hitShare >= kEnclosed) {
      places.push_back({*place, surroundings.clearance});
    }
  }
  const float share = float(places.size()) / float(std::max(kSamples - solid, 1));
  return {thinnedOut(std::move(places)), share};
}

}  // namespace host
