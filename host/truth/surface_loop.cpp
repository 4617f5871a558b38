#include "host/truth/surface_loop.h"

#include <algorithm>
#include <tbb/parallel_for.h>

namespace host {
namespace {

/// Many to a core, and a fraction of a second's work on one.
constexpr int kPointsAtOnce = 1024;

}  // namespace

FloatImage evaluateEach(const GridSurfaces& surfaces, const ValueOfSurface& valueOf,
                        const WorkObserver& observe) {
  FloatImage image{surfaces.grid.size(), 1, std::vector<float>(surfaces.points.size(), 1.0f)};
  const auto evaluate = [&](int i) {
    const SurfacePoint& point = surfaces.points[static_cast<std::size_t>(i)];
    if (!point.background) image.pixels[static_cast<std::size_t>(i)] = valueOf(point, i);
  };
  const auto count = static_cast<int>(surfaces.points.size());
  for (int first = 0; first < count; first += kPointsAtOnce) {
    observe(static_cast<double>(first) / count, "tracing rays");
    tbb::parallel_for(first, std::min(first + kPointsAtOnce, count), evaluate);
  }
  return image;
}

}  // namespace host
