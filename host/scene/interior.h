#pragma once

#include <vector>

#include "host/scene/surface_sampler.h"
#include "host/scene/triangle_grid.h"

namespace host {

/// Places to stand inside of rooms, and how much of the space is rooms.
struct Interior {
  std::vector<glm::vec3> places;
  float share = 0.0f;
};

Interior findInterior(const TriangleGrid& grid, const SurfaceSampler& sampler);

}  // namespace host
