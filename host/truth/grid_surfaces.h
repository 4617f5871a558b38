#pragma once

#include <vector>

#include "host/truth/pixel_grid.h"
#include "mres/frame.h"

namespace host {

/// A point of a surface that a pixel shows, in the world.
struct SurfacePoint {
  glm::vec3 origin{0.0f};   ///< metres; lifted off the surface by what its position may be wrong
  glm::vec3 normal{0.0f};   ///< unit length; before normal mapping, as effects get it
  bool background = false;  ///< there is no surface
};

struct GridSurfaces {
  PixelGrid grid;
  std::vector<SurfacePoint> points;  ///< row by row
};

/// What effects read of a frame at the pixels of a grid. `frame` is one of the host's renderer: normals of
/// the world in 0..1, background at window depth 1.
GridSurfaces readSurfaces(const PixelGrid& grid, const mres::Frame& frame);

}  // namespace host
