#include "host/commands/bench_plots.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "host/commands/gnuplot.h"
#include "host/commands/mean_plots.h"
#include "host/commands/output.h"
#include "host/commands/plot_script.h"

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
  return plot.empty() ? "" : axes("Speedup by picture size", "megapixels", "speedup") + speedupScale() + plot;
}

std::string speedupBySamples(const std::vector<Json>& results) {
  const auto samples = [](const Json& result) { return result["samples"].get<double>(); };
  const auto rest = [](const Json& result) {
    return fmt::format("{}, {}, {}", viewOf(result), result["effect"].get<std::string>(), sizeOf(result));
  };
  const std::string plot = linesOf(speedupOver(results, samples, rest));
  return plot.empty() ? ""
                      : axes("Speedup by samples per pixel", "samples", "speedup") + speedupScale() + plot;
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
  return axes("Error against time", "time, as a share of the full resolution's", "RMS error") +
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

using Bars = std::map<std::string, std::vector<const Json*>>;

/// A bar for each result or, where those are too many, for the results of all views together.
Bars barsOf(const std::vector<Json>& results) {
  constexpr std::size_t kMostBars = 24;
  const bool byView = results.size() <= kMostBars;
  Bars bars;
  for (const Json& result : results)
    bars[fmt::format("{}{}, {}", byView ? viewOf(result) + ", " : "", workOf(result), sizeOf(result))]
        .push_back(&result);
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
  for (const auto& [bar, members] : barsOf(results)) {
    double total = 0.0;
    for (const std::string& name : names) total += totalOf(members, name);
    block += fmt::format("\n\"{}\"", bar);
    for (const std::string& name : names) block += fmt::format(" {}", totalOf(members, name) / total * 100.0);
  }
  return block + "\nEOD\n" + axes("Where the technique's time goes", "", "share of the time, %") +
         fmt::format(
             "set style data histograms\nset style histogram rowstacked\nset style fill solid 0.9\n"
             "set boxwidth 0.8\nset yrange [0:100]\nset xtics rotate by 90 right\nset bmargin 15\nset key "
             "invert\n"
             "plot for [column=2:{}] $stages using column:xtic(1) title columnheader(column)\n",
             names.size() + 1);
}

}  // namespace

std::optional<std::vector<fs::path>> drawPlots(const Json& report, const fs::path& directory) {
  const std::vector<Json> results = timedResults(report);
  const std::vector<std::pair<fs::path, std::string>> scripts{
      {"mean-speedup-by-size.svg", meanSpeedupBySize(results)},
      {"mean-speedup-by-samples.svg", meanSpeedupBySamples(results)},
      {"errors.svg", errorBoxes(report)},
      {"speedup-by-size.svg", speedupBySize(results)},
      {"speedup-by-samples.svg", speedupBySamples(results)},
      {"error-against-time.svg", errorAgainstTime(results)},
      {"stages.svg", stageShares(results)}};
  const fs::path folder = "plots";
  const OutputDirectory output(directory / folder);
  std::vector<fs::path> plots;
  for (const auto& [file, script] : scripts) {
    if (script.empty()) continue;
    if (!drawSvg(output.path() / file, script)) return std::nullopt;
    plots.push_back(folder / file);
  }
  return plots;
}

}  // namespace host
