#include "host/bench/pareto_plots.h"

#include <algorithm>
#include <fmt/format.h>

#include "host/bench/plot_script.h"

namespace host {

// Times from a tenth of the full resolution's to four times as much, and some errors of nothing.
std::string paretoPlot(const ParetoPlane& plane) {
  Series lines;
  for (const ParetoPoint& point : plane.points) lines[point.technique].emplace_back(point.time, point.rms);
  for (auto& [technique, points] : lines) std::ranges::sort(points);
  return axes("time, as a share of the full resolution's", "RMS error") +
         "set logscale x 2\nset yrange [0:*]\n" + plotOf(lines, "linespoints");
}

std::string plotNameOf(const ParetoPlane& plane) {
  return fmt::format("pareto-{}-{}-{}", plane.effect, plane.samples, plane.size);
}

}  // namespace host
