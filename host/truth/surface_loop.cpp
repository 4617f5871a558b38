#include "host/truth/surface_loop.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace host {
namespace {

constexpr int kRowsAtOnce = 16;

/// Calls `work` with each of [first, end), on all cores.
void runOnAllCores(int first, int end, const std::function<void(int)>& work) {
  std::atomic<int> next = first;
  const auto takePart = [&] {
    for (int i = next++; i < end; i = next++) work(i);
  };
  std::vector<std::jthread> helpers;
  for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) helpers.emplace_back(takePart);
  takePart();
}

}  // namespace

FloatImage evaluateEach(const GridSurfaces& surfaces, const ValueOfSurface& valueOf,
                        const WorkObserver& observe) {
  FloatImage image{surfaces.grid.size(), 1, std::vector<float>(surfaces.points.size(), 1.0f)};
  const auto evaluateRow = [&](int row) {
    for (int i = row * image.size.x; i < (row + 1) * image.size.x; ++i) {
      const SurfacePoint& point = surfaces.points[static_cast<std::size_t>(i)];
      if (!point.background) image.pixels[static_cast<std::size_t>(i)] = valueOf(point, i);
    }
  };
  for (int row = 0; row < image.size.y; row += kRowsAtOnce) {
    observe(static_cast<double>(row) / image.size.y, "tracing rays");
    runOnAllCores(row, std::min(row + kRowsAtOnce, image.size.y), evaluateRow);
  }
  return image;
}

}  // namespace host
