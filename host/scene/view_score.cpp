#include "host/scene/view_score.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace host {
namespace {

constexpr glm::ivec2 kRays(14, 8);  // 16:9, roughly
constexpr float kAspect = 16.0f / 9.0f;

using Hits = std::array<std::array<std::optional<RayHit>, kRays.x>, kRays.y>;

Hits traceView(const TriangleGrid& grid, const Camera& camera) {
  const float top = std::tan(camera.verticalFov * 0.5f);
  Hits hits;
  for (int y = 0; y < kRays.y; ++y) {
    for (int x = 0; x < kRays.x; ++x) {
      const glm::vec2 ndc = (glm::vec2(x, y) + 0.5f) / glm::vec2(kRays) * 2.0f - 1.0f;
      const glm::vec3 direction = glm::normalize(glm::vec3(ndc.x * top * kAspect, ndc.y * top, -1.0f));
      hits[y][x] = grid.trace(camera.position, camera.orientation * direction);
    }
  }
  return hits;
}

/// Does a visible edge run between two neighbouring rays: a silhouette, a crease, or another plane behind?
bool isEdge(const std::optional<RayHit>& a, const std::optional<RayHit>& b) {
  if (a.has_value() != b.has_value()) return true;
  if (!a) return false;
  if (glm::dot(a->normal, b->normal) < 0.9f) return true;
  return std::max(a->distance, b->distance) > 1.5f * std::min(a->distance, b->distance);
}

float edgeShare(const Hits& hits) {
  int edges = 0;
  int pairs = 0;
  const auto compare = [&](const std::optional<RayHit>& a, const std::optional<RayHit>& b) {
    edges += isEdge(a, b) ? 1 : 0;
    ++pairs;
  };
  for (int y = 0; y < kRays.y; ++y) {
    for (int x = 0; x < kRays.x; ++x) {
      if (x + 1 < kRays.x) compare(hits[y][x], hits[y][x + 1]);
      if (y + 1 < kRays.y) compare(hits[y][x], hits[y + 1][x]);
    }
  }
  return float(edges) / float(pairs);
}

float ramp(float value, float low, float high) {
  return std::clamp((value - low) / (high - low), 0.0f, 1.0f);
}

}  // namespace

float viewScore(const TriangleGrid& grid, const Camera& camera, float reach) {
  const Hits hits = traceView(grid, camera);
  std::vector<float> distances;
  int backFaces = 0;
  for (const auto& row : hits) {
    for (const auto& hit : row) {
      if (!hit) continue;
      distances.push_back(hit->distance);
      backFaces += hit->isBackFace ? 1 : 0;
    }
  }
  if (distances.empty()) return 0.0f;
  std::sort(distances.begin(), distances.end());
  const auto percentile = [&](float share) {
    return distances[std::size_t(share * float(distances.size() - 1))];
  };

  const auto rays = float(kRays.x * kRays.y);
  const float coverage = ramp(float(distances.size()) / rays, 0.05f, 0.4f);
  const float solidity = 1.0f - ramp(float(backFaces) / float(distances.size()), 0.02f, 0.15f);
  const float shape = 0.15f + 0.85f * ramp(edgeShare(hits), 0.05f, 0.45f);
  const float depth = 0.4f + 0.6f * ramp(percentile(0.85f) / percentile(0.3f), 1.1f, 3.0f);
  const float breadth = 0.2f + 0.8f * ramp(percentile(0.5f) / reach, 0.2f, 1.0f);
  // Something right in front of the lens hides the rest.
  const float clearance = ramp(percentile(0.04f) / percentile(0.5f), 0.1f, 0.35f);
  return coverage * solidity * shape * depth * breadth * clearance;
}

}  // namespace host
