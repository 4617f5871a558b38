// Polylines in the plane with outward normals: the profiles of lathes, the cross-sections of sweeps and
// extrusions.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace host::modelling {

struct ProfilePoint {
  glm::vec2 position{0.0f};
  glm::vec2 normal{0.0f};  ///< unit length, to the right of the way the profile runs
  float arcLength = 0.0f;  ///< from the profile's first point
};

/// A stretch of a profile without a crease.
using SmoothRun = std::vector<ProfilePoint>;

/// Splits a polyline at its creases: corners that turn by more than `creaseDegrees`. A closed profile ends
/// where it began. Coinciding neighbours count once.
std::vector<SmoothRun> smoothRuns(std::span<const glm::vec2> points, bool closed, float creaseDegrees);

/// The arc length at the end of the last run.
float totalLength(const std::vector<SmoothRun>& runs);

/// Triangles (indices into `outline`) of a simple polygon, counter-clockwise, by ear clipping (Meisters,
/// "Polygons have ears", 1975).
std::vector<glm::ivec3> triangulate(std::span<const glm::vec2> outline);

}  // namespace host::modelling
