#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "host/scene/builtin/modelling.h"
#include "host/scene/builtin/profile.h"
#include "host/scene/builtin/surface_grid.h"

namespace host::modelling {

void addLathe(Mesh& mesh, glm::vec3 base, std::span<const glm::vec2> profile, int segments,
              float creaseDegrees) {
  const std::vector<SmoothRun> runs = smoothRuns(profile, false, creaseDegrees);
  const float height = totalLength(runs);
  float widest = 0.0f;
  for (const glm::vec2 point : profile) widest = std::max(widest, point.x);
  for (const SmoothRun& run : runs) {
    std::vector<GridPoint> points;
    for (const ProfilePoint& point : run) {
      for (int column = 0; column <= segments; ++column) {
        const float turn = glm::two_pi<float>() / static_cast<float>(segments);
        const float angle = turn * static_cast<float>(column % segments);  // the seam closes exactly
        const glm::vec3 out(std::cos(angle), 0.0f, -std::sin(angle));
        const glm::vec3 up(0.0f, 1.0f, 0.0f);
        points.push_back({base + point.position.x * out + point.position.y * up,
                          glm::normalize(point.normal.x * out + point.normal.y * up),
                          {turn * static_cast<float>(column) * widest, height - point.arcLength}});
      }
    }
    addGrid(mesh, points, segments + 1);
  }
}

}  // namespace host::modelling
