#include "host/bench/mean_plots.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

#include "host/bench/plot_script.h"
#include "host/measure/result_names.h"
#include "host/measure/statistics.h"

namespace host {
namespace {

using PointsOfViews = std::map<std::string, std::vector<Point>>;

/// A mean over the same views at every point: over those that have at least `leastPoints`.
struct MeanRequest {
  std::function<double(const Json&)> variable;
  std::function<std::string(const Json&)> rest;  ///< what the results of one line share
  std::size_t leastPoints;
};

/// Where a view lacks a point, a mean of the others would tell of the views and not of x.
std::vector<Point> meansOf(const PointsOfViews& views) {
  std::map<double, std::vector<double>> values;
  for (const auto& [view, points] : views)
    for (const auto& [x, y] : points) values[x].push_back(y);
  std::vector<Point> means;
  for (const auto& [x, ys] : values)
    if (ys.size() == views.size()) means.emplace_back(x, mean(ys));
  return means;
}

/// One view that has points which its line lacks goes on alone: the paper's figure 5 has 4224 samples once.
/// More than one have them only where a campaign was interrupted.
Series aloneBeyond(const std::vector<Point>& line, const std::string& name, const PointsOfViews& views) {
  Series series;
  for (const auto& [view, points] : views)
    if (points.size() > line.size()) {
      std::vector<Point>& own = series[fmt::format("{}, {} alone", name, view)];
      own = points;
      std::ranges::sort(own);
    }
  return series.size() == 1 ? series : Series();
}

Series meanSpeedup(const std::vector<Json>& results, const MeanRequest& request) {
  std::map<std::string, PointsOfViews> lines;
  for (const Json& result : results)
    lines[request.rest(result)][viewOf(result)].emplace_back(request.variable(result),
                                                             result["speedup"].get<double>());
  Series series;
  for (auto& [name, views] : lines) {
    std::erase_if(views, [&](const auto& view) { return view.second.size() < request.leastPoints; });
    if (views.size() < 2) continue;
    const std::vector<Point> line = meansOf(views);
    series.merge(aloneBeyond(line, name, views));
    series[fmt::format("{}, {} views", name, views.size())] = line;
  }
  return series;
}

struct Box {
  std::string name;
  double pixels = 0.0;
  std::vector<double> values;
};

/// Of one effect, by size and samples.
std::vector<Box> boxesOf(const std::string& effect, const Json& results) {
  std::map<std::tuple<double, int>, Box> boxes;
  for (const Json& result : results) {
    if (result["effect"] != effect || result["error"].is_null()) continue;
    Box& box = boxes[{megapixels(result), result["samples"].get<int>()}];
    box.name = fmt::format("{}\\n{}", workOf(result), sizeOf(result));
    box.pixels = megapixels(result);
    box.values.push_back(result["error"]["rms"].get<double>());
  }
  std::vector<Box> list;
  list.reserve(boxes.size());
  for (auto& [key, box] : boxes) list.push_back(std::move(box));
  return list;
}

/// Those with the most views and, of these, the most pixels: the same pictures for all numbers of samples.
std::vector<Box> fullest(std::vector<Box> boxes) {
  const auto rank = [](const Box& box) { return std::pair(box.values.size(), box.pixels); };
  if (boxes.empty()) return boxes;
  const auto best = rank(*std::ranges::max_element(boxes, {}, rank));
  std::erase_if(boxes, [&](const Box& box) { return rank(box) != best; });
  return boxes;
}

std::set<std::string> effectsOf(const Json& results) {
  std::set<std::string> effects;
  for (const Json& result : results) effects.insert(result["effect"].get<std::string>());
  return effects;
}

std::string scriptOf(const std::vector<Box>& boxes) {
  std::string blocks;
  std::string tics;
  std::string commands;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    blocks += fmt::format("$box{} << EOD\n{}\nEOD\n", i, fmt::join(boxes[i].values, "\n"));
    tics += fmt::format("{}\"{}\" {}", i == 0 ? "" : ", ", boxes[i].name, i + 1);
    commands += fmt::format("{}$box{} using ({}):1 with boxplot", i == 0 ? "plot " : ", ", i, i + 1);
  }
  return blocks + axes("", "RMS error") +
         fmt::format(
             "unset key\nset bmargin 4\nset xrange [0.4:{}.6]\nset yrange [0:*]\nset boxwidth 0.4\n"
             "set style fill solid 0.3\nset style boxplot outliers pointtype 7\nset xtics ({})\n{}\n",
             boxes.size(), tics, commands);
}

}  // namespace

std::string meanSpeedupBySize(const std::vector<Json>& timedResults) {
  constexpr std::size_t kLeastSizes = 2;
  const std::string plot =
      plotOf(meanSpeedup(timedResults, {megapixels, workOf, kLeastSizes}), "linespoints");
  return plot.empty() ? "" : axes("megapixels", "speedup") + speedupScale() + plot;
}

std::string meanSpeedupBySamples(const std::vector<Json>& timedResults) {
  // Many views have a second number of samples for their errors; those that make a line have more.
  constexpr std::size_t kLeastSamples = 3;
  const auto samples = [](const Json& result) { return result["samples"].get<double>(); };
  const auto rest = [](const Json& result) {
    return fmt::format("{}, {}", result["effect"].get<std::string>(), sizeOf(result));
  };
  const std::string plot = plotOf(meanSpeedup(timedResults, {samples, rest, kLeastSamples}), "linespoints");
  return plot.empty() ? "" : axes("samples", "speedup") + speedupScale() + "set logscale x 2\n" + plot;
}

std::string errorBoxes(const Json& report) {
  constexpr std::size_t kLeastValues = 5;  // a box shows as many
  std::vector<Box> boxes;
  for (const std::string& effect : effectsOf(report["results"]))
    std::ranges::move(fullest(boxesOf(effect, report["results"])), std::back_inserter(boxes));
  std::erase_if(boxes, [](const Box& box) { return box.values.size() < kLeastValues; });
  return boxes.empty() ? "" : scriptOf(boxes);
}

}  // namespace host
