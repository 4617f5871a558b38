#include "host/bench/summary.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

#include "host/measure/interleaved.h"
#include "host/measure/result_names.h"
#include "host/measure/statistics.h"

namespace host {
namespace {

struct Group {
  int views = 0;
  std::string size;
  std::vector<double> speedups;  ///< of those that were timed
  std::vector<double> errors;
};

using Key = std::tuple<std::string, int, double>;  // effect, samples, megapixels

std::map<Key, Group> groupsOf(const Json& results) {
  std::map<Key, Group> groups;
  for (const Json& result : results) {
    Group& group = groups[{result["effect"], result["samples"], megapixels(result)}];
    ++group.views;
    group.size = sizeOf(result);
    if (!result["speedup"].is_null()) group.speedups.push_back(result["speedup"]);
    if (!result["error"].is_null()) group.errors.push_back(result["error"]["rms"]);
  }
  return groups;
}

/// Mean, least and greatest; "-" for none.
std::vector<std::string> cellsOf(const std::vector<double>& values, const char* format) {
  if (values.empty()) return {"-", "-", "-"};
  const auto [least, greatest] = std::ranges::minmax(values);
  std::vector<std::string> cells;
  for (const double value : {mean(values), least, greatest})
    cells.push_back(fmt::format(fmt::runtime(format), value));
  return cells;
}

/// What timing repeats for unless it is told otherwise.
constexpr double kKnownWithin = RepeatPlan{}.precision;

std::size_t pairsOf(const Json& timed) {
  return timed["time_ms"]["runs"].get<std::size_t>();
}

/// Of one pair.
double millisecondsOf(const Json& timed) {
  return timed["time_ms"]["median"].get<double>() + timed["reference_time_ms"]["median"].get<double>();
}

bool hasKnownSpeedup(const Json& timed) {
  const Json& interval = timed["speedup_interval"];
  if (interval.is_null()) return false;
  const RatioEstimate speedup{.ratio = timed["speedup"].get<double>(),
                              .low = interval[0].get<double>(),
                              .high = interval[1].get<double>(),
                              .pairs = pairsOf(timed)};
  return speedup.isKnownWithin(kKnownWithin);
}

}  // namespace

std::vector<std::vector<std::string>> summaryRows(const Json& report) {
  std::vector<std::vector<std::string>> rows{{"effect", "samples", "size", "views", "mean speedup", "least",
                                              "greatest", "mean RMS", "least", "greatest"}};
  for (const auto& [key, group] : groupsOf(report["results"])) {
    std::vector<std::string> row{std::get<0>(key), std::to_string(std::get<1>(key)), group.size,
                                 std::to_string(group.views)};
    std::ranges::move(cellsOf(group.speedups, "{:.2f}x"), std::back_inserter(row));
    std::ranges::move(cellsOf(group.errors, "{:.4f}"), std::back_inserter(row));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string speedupCertainty(const Json& report) {
  std::size_t timed = 0;
  std::size_t known = 0;
  const Json* slowest = nullptr;
  for (const Json& result : report["results"]) {
    if (result["speedup"].is_null()) continue;
    ++timed;
    if (hasKnownSpeedup(result)) ++known;
    if (!slowest || millisecondsOf(result) > millisecondsOf(*slowest)) slowest = &result;
  }
  if (!slowest) return {};
  const std::size_t pairs = pairsOf(*slowest);
  return fmt::format(
      "The speedup is known within {:.0f} % (95 % interval) for {} of {} timed pictures; the slowest has {}.",
      kKnownWithin * 100.0, known, timed, pairs == 1 ? "one pair" : fmt::format("{} pairs", pairs));
}

}  // namespace host
