#include <array>

#include "host/scene/builtin/modelling.h"
#include "host/scene/builtin/profile.h"
#include "host/scene/builtin/surface_grid.h"

namespace host::modelling {
namespace {

/// The outline's area at height z, facing `facing` (+1 or -1) along z.
void addLid(Mesh& mesh, std::span<const glm::vec2> outline, float z, float facing) {
  for (glm::ivec3 triangle : triangulate(outline)) {
    if (facing < 0.0f) std::swap(triangle.y, triangle.z);
    std::array<GridPoint, 3> corners;
    for (int i = 0; i < 3; ++i) {
      const glm::vec2 p = outline[triangle[i]];
      corners[i] = {{p, z}, {0.0f, 0.0f, facing}, {facing * p.x, -p.y}};
    }
    addFacet(mesh, corners, {facing, 0.0f, 0.0f});
  }
}

}  // namespace

void addExtrusion(Mesh& mesh, std::span<const glm::vec2> outline, float depth, float creaseDegrees) {
  addLid(mesh, outline, 0.0f, -1.0f);
  addLid(mesh, outline, depth, 1.0f);
  for (const SmoothRun& run : smoothRuns(outline, true, creaseDegrees)) {
    std::vector<GridPoint> points;
    for (const float z : {0.0f, depth}) {  // seen from outside, the outline runs to the right when +z is up
      for (const ProfilePoint& point : run) {
        points.push_back({{point.position, z}, {point.normal, 0.0f}, {point.arcLength, depth - z}});
      }
    }
    addGrid(mesh, points, static_cast<int>(run.size()));
  }
}

}  // namespace host::modelling
