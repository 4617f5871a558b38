#include "host/commands/bench_plots.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "host/commands/gnuplot.h"
#include "host/commands/output.h"

namespace host {
namespace fs = std::filesystem;
namespace {

using Point = std::pair<double, double>;
using Series = std::map<std::string, std::vector<Point>>;

std::string viewOf(const Json& result) {
  return fmt::format("{} {}", result["scene"].get<std::string>(), result["camera"].get<int>());
}

std::string sizeOf(const Json& result) {
  return fmt::format("{}x{}", result["width"].get<int>(), result["height"].get<int>());
}

double megapixels(const Json& result) {
  return result["width"].get<double>() * result["height"].get<double>() / 1e6;
}

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

std::string plotOf(const Series& series, const std::string& style) {
  std::string blocks;
  std::string commands;
  for (const auto& [name, points] : series) {
    const std::string block = fmt::format("$series{}", std::distance(series.begin(), series.find(name)));
    blocks += block + " << EOD\n";
    for (const auto& [x, y] : points) blocks += fmt::format("{} {}\n", x, y);
    blocks += "EOD\n";
    commands += fmt::format("{}{} with {} title {}", commands.empty() ? "plot " : ", ", block, style,
                            gnuplotQuoted(name));
  }
  return series.empty() ? "" : blocks + commands + "\n";
}

std::string axes(const std::string& title, const std::string& x, const std::string& y) {
  return fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n", gnuplotQuoted(title), gnuplotQuoted(x),
                     gnuplotQuoted(y));
}

constexpr const char* kEvenLine =
    "set yrange [0:*]\nset arrow from graph 0, first 1 to graph 1, first 1 nohead dashtype 2\n";

std::string speedupBySize(const std::vector<Json>& results) {
  const std::string plot =
      plotOf(speedupOver(results, megapixels,
                         [](const Json& result) {
                           return fmt::format("{}, {} samples", viewOf(result), result["samples"].get<int>());
                         }),
             "linespoints");
  return plot.empty() ? "" : axes("Speedup by picture size", "megapixels", "speedup") + kEvenLine + plot;
}

std::string speedupBySamples(const std::vector<Json>& results) {
  const auto samples = [](const Json& result) { return result["samples"].get<double>(); };
  const std::string plot = plotOf(
      speedupOver(results, samples,
                  [](const Json& result) { return fmt::format("{}, {}", viewOf(result), sizeOf(result)); }),
      "linespoints");
  return plot.empty() ? "" : axes("Speedup by samples per pixel", "samples", "speedup") + kEvenLine + plot;
}

/// The plane on which techniques compete: further down and to the left is better.
std::string errorAgainstTime(const std::vector<Json>& results) {
  Series series;
  for (const Json& result : results)
    series[result["scene"].get<std::string>()].emplace_back(1.0 / result["speedup"].get<double>(),
                                                            result["error"]["rms"].get<double>());
  const std::string plot = plotOf(series, "points pointsize 1.2");
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

std::string stageShares(const std::vector<Json>& results) {
  const std::vector<std::string> names = stageNames(results);
  if (names.empty()) return "";
  std::string block = "$stages << EOD\nresult";
  for (const std::string& name : names) block += " " + name;
  for (const Json& result : results) {
    const Json& stages = result["stages_ms"];
    double total = 0.0;
    for (const Json& time : stages) total += time.get<double>();
    block += fmt::format("\n\"{}, {}, {}\"", viewOf(result), sizeOf(result), result["samples"].get<int>());
    for (const std::string& name : names)
      block += fmt::format(" {}", stages.value(name, 0.0) / total * 100.0);
  }
  return block + "\nEOD\n" + axes("Where the technique's time goes", "", "share of the time, %") +
         fmt::format(
             "set style data histograms\nset style histogram rowstacked\nset style fill solid 0.9\n"
             "set boxwidth 0.8\nset yrange [0:100]\nset xtics rotate by 90 right\nset bmargin 13\nset key "
             "invert\n"
             "plot for [column=2:{}] $stages using column:xtic(1) title columnheader(column)\n",
             names.size() + 1);
}

}  // namespace

std::optional<std::vector<fs::path>> drawPlots(const Json& report, const fs::path& directory) {
  const std::vector<Json> results = timedResults(report);
  const std::vector<std::pair<fs::path, std::string>> scripts{
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
