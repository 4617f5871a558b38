#include "host/scene/builtin/profile.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace host::modelling {
namespace {

constexpr float kCoincident = 1e-6f;  // metres

std::vector<glm::vec2> withoutRepeats(std::span<const glm::vec2> points, bool closed) {
  std::vector<glm::vec2> kept;
  for (const glm::vec2 point : points) {
    if (kept.empty() || glm::distance(kept.back(), point) > kCoincident) kept.push_back(point);
  }
  if (closed && kept.size() > 1 && glm::distance(kept.front(), kept.back()) <= kCoincident) kept.pop_back();
  return kept;
}

/// The corners of a profile and the straight segments between them; segment i starts at corner i.
class Segments {
 public:
  Segments(std::vector<glm::vec2> corners, bool closed, float creaseDegrees)
      : corners_(std::move(corners)),
        closed_(closed),
        creaseCosine_(std::cos(glm::radians(creaseDegrees))),
        count_(static_cast<int>(corners_.size()) - (closed ? 0 : 1)) {}

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] glm::vec2 start(int segment) const { return corners_[wrap(segment)]; }
  [[nodiscard]] glm::vec2 end(int segment) const { return corners_[(wrap(segment) + 1) % corners_.size()]; }
  [[nodiscard]] float length(int segment) const { return glm::distance(start(segment), end(segment)); }
  [[nodiscard]] glm::vec2 normal(int segment) const {
    const glm::vec2 along = (end(segment) - start(segment)) / length(segment);
    return {along.y, -along.x};
  }
  /// Whether segment i and the one before it meet smoothly.
  [[nodiscard]] bool smoothBefore(int segment) const {
    if (!closed_ && (segment <= 0 || segment >= count_)) return false;
    return glm::dot(normal(segment - 1), normal(segment)) >= creaseCosine_;
  }
  /// A segment to start with, so that no run is cut in two by the wrap-around.
  [[nodiscard]] int firstSegment() const {
    for (int i = 0; closed_ && i < count_; ++i) {
      if (!smoothBefore(i)) return i;
    }
    return 0;
  }

 private:
  [[nodiscard]] int wrap(int segment) const { return (segment % count_ + count_) % count_; }

  std::vector<glm::vec2> corners_;
  bool closed_;
  float creaseCosine_;
  int count_;
};

float cross(glm::vec2 a, glm::vec2 b) {
  return a.x * b.y - a.y * b.x;
}

bool insideTriangle(glm::vec2 p, glm::vec2 a, glm::vec2 b, glm::vec2 c) {
  return cross(b - a, p - a) >= 0.0f && cross(c - b, p - b) >= 0.0f && cross(a - c, p - c) >= 0.0f;
}

bool isEar(std::span<const glm::vec2> outline, const std::vector<int>& left, std::size_t corner) {
  const std::size_t n = left.size();
  const int ia = left[(corner + n - 1) % n];
  const int ib = left[corner];
  const int ic = left[(corner + 1) % n];
  const glm::vec2 a = outline[ia];
  const glm::vec2 b = outline[ib];
  const glm::vec2 c = outline[ic];
  if (cross(b - a, c - b) <= 1e-9f) return false;
  return std::none_of(left.begin(), left.end(), [&](int i) {
    return i != ia && i != ib && i != ic && insideTriangle(outline[i], a, b, c);
  });
}

}  // namespace

std::vector<SmoothRun> smoothRuns(std::span<const glm::vec2> points, bool closed, float creaseDegrees) {
  const Segments segments(withoutRepeats(points, closed), closed, creaseDegrees);
  std::vector<SmoothRun> runs;
  float arcLength = 0.0f;
  const int first = segments.firstSegment();
  for (int i = first; i < first + segments.count(); ++i) {
    const glm::vec2 normal = segments.normal(i);
    const bool joins = segments.smoothBefore(i);
    const glm::vec2 startNormal = joins ? glm::normalize(segments.normal(i - 1) + normal) : normal;
    if (!joins || runs.empty()) runs.push_back({{segments.start(i), startNormal, arcLength}});
    const glm::vec2 endNormal =
        segments.smoothBefore(i + 1) ? glm::normalize(normal + segments.normal(i + 1)) : normal;
    arcLength += segments.length(i);
    runs.back().push_back({segments.end(i), endNormal, arcLength});
  }
  return runs;
}

float totalLength(const std::vector<SmoothRun>& runs) {
  return runs.empty() ? 0.0f : runs.back().back().arcLength;
}

std::vector<glm::ivec3> triangulate(std::span<const glm::vec2> outline) {
  std::vector<int> left(outline.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = static_cast<int>(i);
  std::vector<glm::ivec3> triangles;
  while (left.size() > 2) {
    std::size_t ear = 0;
    while (ear < left.size() && !isEar(outline, left, ear)) ++ear;
    const std::size_t n = left.size();
    if (ear == n) break;  // what remains has no area
    triangles.emplace_back(left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return triangles;
}

}  // namespace host::modelling
