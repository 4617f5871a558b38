#include "host/bench/plots.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <string>
#include <system_error>
#include <tuple>

#include "host/bench/gnuplot.h"
#include "host/bench/mean_plots.h"
#include "host/bench/pareto_plots.h"
#include "host/bench/pareto_tables.h"
#include "host/bench/plot_script.h"
#include "host/console/output.h"
#include "host/measure/result_names.h"

namespace host {
namespace fs = std::filesystem;
namespace {

std::vector<Json> timedResults(const Json& report) {
  std::vector<Json> timed;
  std::ranges::copy_if(report["results"], std::back_inserter(timed),
                       [](const Json& result) { return !result["speedup"].is_null(); });
  return timed;
}

/// Speedup over `variable`: a series for each set of results that differ in nothing else, if at least two do.
Series speedupOver(const std::vector<Json>& results, const std::function<double(const Json&)>& variable,
                   const std::function<std::string(const Json&)>& rest) {
  Series series;
  for (const Json& result : results)
    series[rest(result)].emplace_back(variable(result), result["speedup"].get<double>());
  std::erase_if(series, [](const auto& entry) { return entry.second.size() < 2; });
  for (auto& [name, points] : series) std::ranges::sort(points);
  return series;
}

/// Nothing for more than can be told apart: there, means tell more.
std::string linesOf(const Series& series) {
  return series.size() <= kMostSeries ? plotOf(series, "linespoints") : "";
}

std::string speedupBySize(const std::vector<Json>& results) {
  const auto rest = [](const Json& result) { return fmt::format("{}, {}", viewOf(result), workOf(result)); };
  const std::string plot = linesOf(speedupOver(results, megapixels, rest));
  return plot.empty() ? "" : axes("megapixels", "speedup") + speedupScale() + plot;
}

std::string speedupBySamples(const std::vector<Json>& results) {
  const auto samples = [](const Json& result) { return result["samples"].get<double>(); };
  const auto rest = [](const Json& result) {
    return fmt::format("{}, {}, {}", viewOf(result), result["effect"].get<std::string>(), sizeOf(result));
  };
  const std::string plot = linesOf(speedupOver(results, samples, rest));
  return plot.empty() ? "" : axes("samples", "speedup") + speedupScale() + plot;
}

/// The plane on which techniques compete: further down and to the left is better.
std::string errorAgainstTime(const std::vector<Json>& results) {
  Series byScene;
  Series byEffect;
  for (const Json& result : results) {
    const Point point(1.0 / result["speedup"].get<double>(), result["error"]["rms"].get<double>());
    const auto effect = result["effect"].get<std::string>();
    byScene[fmt::format("{}, {}", result["scene"].get<std::string>(), effect)].push_back(point);
    byEffect[effect].push_back(point);
  }
  const std::string plot = plotOf(byScene.size() <= kMostSeries ? byScene : byEffect, "points pointsize 1.2");
  if (plot.empty()) return "";
  return axes("time, as a share of the full resolution's", "RMS error") +
         "set xrange [0:*]\nset yrange [0:*]\n" + plot;
}

/// Stage names in the order of first appearance.
std::vector<std::string> stageNames(const std::vector<Json>& results) {
  std::vector<std::string> names;
  for (const Json& result : results)
    for (const auto& [name, time] : result["stages_ms"].items())
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  return names;
}

struct Bar {
  std::string label;
  std::vector<const Json*> results;
};

/// What bars are ordered by: scene, camera, effect, samples, megapixels.
using BarKey = std::tuple<std::string, int, std::string, int, double>;

BarKey keyOf(const Json& result, bool byView) {
  return {byView ? result["scene"].get<std::string>() : "", byView ? result["camera"].get<int>() : 0,
          result["effect"].get<std::string>(), result["samples"].get<int>(), megapixels(result)};
}

/// Without quotation marks, which would end it.
std::string labelOf(const Json& result, bool byView) {
  std::string label =
      fmt::format("{}{}, {}", byView ? viewOf(result) + ", " : "", workOf(result), sizeOf(result));
  std::erase(label, '"');
  return label;
}

/// A bar for each result or, where those are too many, for the results of all views together.
std::map<BarKey, Bar> barsOf(const std::vector<Json>& results) {
  constexpr std::size_t kMostBars = 24;
  const bool byView = results.size() <= kMostBars;
  std::map<BarKey, Bar> bars;
  for (const Json& result : results) {
    Bar& bar = bars[keyOf(result, byView)];
    bar.label = labelOf(result, byView);
    bar.results.push_back(&result);
  }
  return bars;
}

/// Of one stage, over all of a bar's results.
double totalOf(const std::vector<const Json*>& results, const std::string& stage) {
  double total = 0.0;
  for (const Json* result : results) total += (*result)["stages_ms"].value(stage, 0.0);
  return total;
}

std::string stageShares(const std::vector<Json>& results) {
  const std::vector<std::string> names = stageNames(results);
  if (names.empty()) return "";
  std::string block = "$stages << EOD\nresult";
  for (const std::string& name : names) block += " " + name;
  for (const auto& [key, bar] : barsOf(results)) {
    double total = 0.0;
    for (const std::string& name : names) total += totalOf(bar.results, name);
    block += fmt::format("\n\"{}\"", bar.label);
    for (const std::string& name : names)
      block += fmt::format(" {}", totalOf(bar.results, name) / total * 100.0);
  }
  return block + "\nEOD\n" + axes("", "share of the time, %") +
         fmt::format(
             "set style data histograms\nset style histogram rowstacked\nset style fill solid 0.9\n"
             "set boxwidth 0.8\nset yrange [0:100]\nset xtics rotate by 90 right\nset bmargin 15\nset key "
             "invert\n"
             "plot for [column=2:{}] $stages using column:xtic(1) title columnheader(column)\n",
             names.size() + 1);
}

/// What drawSvg() left of older reports.
void removeOthers(const fs::path& folder, const std::vector<Plot>& plots) {
  const auto isDrawn = [&](const fs::path& file) {
    return std::ranges::any_of(plots, [&](const Plot& plot) { return plot.file.stem() == file.stem(); });
  };
  std::error_code ignored;  // an old plot that cannot be removed is on no page
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (const fs::path type = entry.path().extension(); type == ".svg" || type == ".gp")
      if (!isDrawn(entry.path())) fs::remove(entry.path(), ignored);
}

struct PlotScript {
  std::string name;  ///< of the file, without extension
  std::string title;
  std::string commands;  ///< none: there is nothing to plot
};

/// A plot for each plane of rivals, then what is told of mres alone.
std::vector<PlotScript> scriptsOf(const Json& report) {
  std::vector<PlotScript> scripts;
  for (const ParetoPlane& plane : paretoPlanes(report))
    scripts.push_back({plotNameOf(plane), "Time against error: " + titleOf(plane), paretoPlot(plane)});
  const Json own = withoutRivals(report);
  const std::vector<Json> results = timedResults(own);
  const std::vector<PlotScript> ownScripts{
      {"mean-speedup-by-size", "Mean speedup by picture size (the paper's figure 6)",
       meanSpeedupBySize(results)},
      {"mean-speedup-by-samples", "Mean speedup by samples per pixel (the paper's figure 5)",
       meanSpeedupBySamples(results)},
      {"errors", "Error of all views (the paper's figure 10)", errorBoxes(own)},
      {"speedup-by-size", "Speedup by picture size", speedupBySize(results)},
      {"speedup-by-samples", "Speedup by samples per pixel", speedupBySamples(results)},
      {"error-against-time", "Error against time", errorAgainstTime(results)},
      {"stages", "Where the technique's time goes", stageShares(results)}};
  scripts.insert(scripts.end(), ownScripts.begin(), ownScripts.end());
  return scripts;
}

}  // namespace

std::optional<std::vector<Plot>> drawPlots(const Json& report, const fs::path& directory) {
  const fs::path folder = "plots";
  const OutputDirectory output(directory / folder);
  std::vector<Plot> plots;
  for (const auto& [name, title, commands] : scriptsOf(report)) {
    if (commands.empty()) continue;
    const fs::path file = fs::path(name) += ".svg";
    if (!drawSvg(output.path() / file, fmt::format("set title {}\n{}", gnuplotQuoted(title), commands)))
      return std::nullopt;
    plots.push_back({folder / file, title});
  }
  removeOthers(output.path(), plots);
  return plots;
}

}  // namespace host
