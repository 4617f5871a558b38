#include "host/truth/grid_surfaces.h"

#include <algorithm>
#include <cmath>

#include "host/renderer/read_texture.h"

namespace host {
namespace {

// Rasterisers interpolate window depth with an error of a few of its steps.
constexpr double kDepthSteps = 4.0;
// Rays start at floats: a few of the steps of the largest coordinate.
constexpr double kRoundingOfPosition = 4.0 * 0x1p-24;

class Unprojection {
 public:
  explicit Unprojection(const mres::Frame& frame)
      : worldFromClip_(glm::inverse(glm::dmat4(frame.projection) * glm::dmat4(frame.view))),
        size_(frame.size) {}

  /// `pixel`: column, and row from the top.
  [[nodiscard]] glm::dvec3 operator()(glm::ivec2 pixel, double windowDepth) const {
    const glm::dvec2 centre(pixel.x + 0.5, size_.y - pixel.y - 0.5);
    const glm::dvec4 clip(centre / glm::dvec2(size_) * 2.0 - 1.0, windowDepth * 2.0 - 1.0, 1.0);
    const glm::dvec4 world = worldFromClip_ * clip;
    return glm::dvec3(world) / world.w;
  }

 private:
  glm::dmat4 worldFromClip_;
  glm::ivec2 size_;
};

SurfacePoint pointAt(const Unprojection& unproject, glm::ivec2 pixel, float depth, glm::vec3 texel) {
  if (depth >= 1.0f) return {.background = true};
  const glm::dvec3 position = unproject(pixel, depth);
  const double step = glm::distance(position, unproject(pixel, std::nextafter(depth, 0.0f)));
  const glm::dvec3 magnitude = glm::abs(position);
  const double largest = std::max({magnitude.x, magnitude.y, magnitude.z});
  const glm::dvec3 normal = glm::normalize(glm::dvec3(texel) * 2.0 - 1.0);
  const double lift = kDepthSteps * step + kRoundingOfPosition * largest;
  return {glm::vec3(position + lift * normal), glm::vec3(normal), false};
}

}  // namespace

GridSurfaces readSurfaces(const PixelGrid& grid, const mres::Frame& frame) {
  const FloatImage depths = valuesAt(grid, readTexture(frame.depth, frame.size, 1));
  const FloatImage normals = valuesAt(grid, readTexture(frame.normals, frame.size, 3));
  const Unprojection unproject(frame);
  GridSurfaces surfaces{grid, {}};
  surfaces.points.reserve(depths.pixels.size());
  for (int y = 0; y < depths.size.y; ++y)
    for (int x = 0; x < depths.size.x; ++x) {
      const std::size_t i = surfaces.points.size();
      const float* texel = &normals.pixels[3 * i];
      surfaces.points.push_back(
          pointAt(unproject, grid.pixel({x, y}), depths.pixels[i], {texel[0], texel[1], texel[2]}));
    }
  return surfaces;
}

}  // namespace host
