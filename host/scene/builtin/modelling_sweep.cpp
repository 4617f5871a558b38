#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtx/quaternion.hpp>
#include <stdexcept>

#include "host/scene/builtin/modelling.h"
#include "host/scene/builtin/profile.h"
#include "host/scene/builtin/surface_grid.h"

namespace host::modelling {
namespace {

/// The frame of one straight piece of the path.
struct Frame {
  glm::vec3 right, up, along;
  [[nodiscard]] glm::vec3 plane(glm::vec2 p) const { return p.x * right + p.y * up; }
};

Frame startFrame(glm::vec3 along, glm::vec3 up) {
  const glm::vec3 upright = tangentAlong(up, along);
  return {glm::cross(along, upright), upright, along};
}

/// The polyline that a sweep follows; piece i runs from point i to point i + 1. Frames go from piece to piece
/// by the smallest rotation (parallel transport).
class Path {
 public:
  Path(std::span<const glm::vec3> points, bool closed, float creaseDegrees, glm::vec3 up)
      : points_(points.begin(), points.end()),
        closed_(closed),
        creaseCosine_(std::cos(glm::radians(creaseDegrees))) {
    pieces_ = static_cast<int>(points.size()) - (closed ? 0 : 1);
    if (pieces_ < 1) throw std::invalid_argument("A sweep needs a path of at least two points; add points.");
    for (int i = 0; i < pieces_; ++i) {
      const glm::vec3 along = glm::normalize(point(i + 1) - point(i));
      if (i == 0) {
        frames_.push_back(startFrame(along, up));
        continue;
      }
      const glm::quat turn = glm::rotation(frames_.back().along, along);
      frames_.push_back({turn * frames_.back().right, turn * frames_.back().up, along});
    }
  }

  [[nodiscard]] int pieces() const { return pieces_; }
  [[nodiscard]] glm::vec3 point(int i) const { return points_[static_cast<std::size_t>(i) % points_.size()]; }
  [[nodiscard]] const Frame& frame(int piece) const { return frames_[wrap(piece)]; }

  /// Whether two pieces meet at the start of `piece`, at a corner or smoothly.
  [[nodiscard]] bool meets(int piece) const { return closed_ || (piece > 0 && piece < pieces_); }
  [[nodiscard]] bool smoothAt(int piece) const {
    return meets(piece) && glm::dot(frame(piece - 1).along, frame(piece).along) >= creaseCosine_;
  }

  /// The cross-section's point `p` at the start of `piece`, where the mitre plane of the corner cuts the
  /// sweep.
  [[nodiscard]] glm::vec3 mitred(int piece, glm::vec2 p) const {
    const Frame& here = frame(meets(piece) ? piece : std::clamp(piece, 0, pieces_ - 1));
    const glm::vec3 offset = here.plane(p);
    if (!meets(piece)) return point(piece) + offset;
    const glm::vec3 mitre = glm::normalize(frame(piece - 1).along + here.along);
    return point(piece) + offset - here.along * (glm::dot(offset, mitre) / glm::dot(here.along, mitre));
  }

  /// Pieces between two creases: first and last, both included.
  [[nodiscard]] std::vector<glm::ivec2> smoothStretches() const {
    int first = 0;
    while (closed_ && first < pieces_ && smoothAt(first)) ++first;
    std::vector<glm::ivec2> stretches;
    for (int i = 0; i < pieces_; ++i) {
      const int piece = first % pieces_ + i;
      if (stretches.empty() || !smoothAt(piece)) stretches.emplace_back(piece, piece);
      stretches.back().y = piece;
    }
    return stretches;
  }

 private:
  [[nodiscard]] std::size_t wrap(int piece) const {
    return static_cast<std::size_t>((piece % pieces_ + pieces_) % pieces_);
  }

  std::vector<glm::vec3> points_;
  bool closed_;
  float creaseCosine_;
  int pieces_ = 0;
  std::vector<Frame> frames_;
};

/// Where the sweep is at one point of the path, seen from the stretch that it belongs to.
struct Station {
  int piece;          // the piece that starts here
  int before, after;  // the pieces whose normals are averaged
  float arcLength;
};

std::vector<Station> stationsOf(const Path& path, glm::ivec2 stretch, float& arcLength) {
  std::vector<Station> stations;
  for (int piece = stretch.x; piece <= stretch.y + 1; ++piece) {
    const bool smooth = path.smoothAt(piece);
    const int before = piece > stretch.x || smooth ? piece - 1 : piece;
    const int after = piece <= stretch.y || smooth ? piece : piece - 1;
    if (piece > stretch.x) arcLength += glm::distance(path.point(piece - 1), path.point(piece));
    stations.push_back({piece, before, after, arcLength});
  }
  return stations;
}

void addSleeve(Mesh& mesh, const Path& path, const std::vector<Station>& stations, const SmoothRun& run,
               float girth) {
  std::vector<GridPoint> points;
  for (const ProfilePoint& profile : run) {
    for (const Station& station : stations) {
      const glm::vec3 normal =
          path.frame(station.before).plane(profile.normal) + path.frame(station.after).plane(profile.normal);
      points.push_back({path.mitred(station.piece, profile.position),
                        glm::normalize(normal),
                        {station.arcLength, girth - profile.arcLength}});
    }
  }
  addGrid(mesh, points, static_cast<int>(stations.size()));
}

/// Closes an open end; `facing` is +1 at the end and -1 at the start.
void addCap(Mesh& mesh, std::span<const glm::vec2> outline, const Frame& frame, glm::vec3 centre,
            float facing) {
  const glm::vec3 normal = facing * frame.along;
  const glm::vec3 right = -facing * frame.right;  // as seen by someone who looks at the cap
  for (glm::ivec3 triangle : triangulate(outline)) {
    if (facing > 0.0f) std::swap(triangle.y, triangle.z);
    std::array<GridPoint, 3> corners;
    for (int i = 0; i < 3; ++i) {
      const glm::vec2 p = outline[triangle[i]];
      corners[i] = {centre + frame.plane(p), normal, {-facing * p.x, -p.y}};
    }
    addFacet(mesh, corners, right);
  }
}

}  // namespace

void addSweep(Mesh& mesh, std::span<const glm::vec2> crossSection, std::span<const glm::vec3> path,
              bool closedPath, float creaseDegrees, glm::vec3 up) {
  const Path way(path, closedPath, creaseDegrees, up);
  const std::vector<SmoothRun> runs = smoothRuns(crossSection, true, creaseDegrees);
  float arcLength = 0.0f;
  for (const glm::ivec2 stretch : way.smoothStretches()) {
    const std::vector<Station> stations = stationsOf(way, stretch, arcLength);
    for (const SmoothRun& run : runs) addSleeve(mesh, way, stations, run, totalLength(runs));
  }
  if (closedPath) return;
  addCap(mesh, crossSection, way.frame(0), path.front(), -1.0f);
  addCap(mesh, crossSection, way.frame(way.pieces() - 1), path.back(), 1.0f);
}

}  // namespace host::modelling
