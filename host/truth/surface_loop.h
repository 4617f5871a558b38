#pragma once

#include <functional>

#include "host/truth/grid_surfaces.h"
#include "host/truth/work_observer.h"

namespace host {

/// An effect's value at a surface, which `index` tells from all others of the grid.
using ValueOfSurface = std::function<float(const SurfacePoint& point, int index)>;

/// The picture of a value at each surface of the grid, 1 where there is none, on all cores. `observe` is
/// called on the calling thread, between some surfaces and the next.
FloatImage evaluateEach(const GridSurfaces& surfaces, const ValueOfSurface& valueOf,
                        const WorkObserver& observe);

}  // namespace host
