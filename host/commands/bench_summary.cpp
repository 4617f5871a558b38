#include "host/commands/bench_summary.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

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

}  // namespace host
