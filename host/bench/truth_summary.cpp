#include "host/bench/truth_summary.h"

#include <fmt/format.h>
#include <map>
#include <tuple>

#include "host/measure/result_names.h"

namespace host {
namespace {

/// Sums over views.
struct Group {
  int views = 0;
  double reference = 0.0;
  double technique = 0.0;
};

using Key = std::tuple<std::string, int, std::string, std::string>;  // effect, samples, size, truth

std::map<Key, Group> groupsOf(const Json& results) {
  std::map<Key, Group> groups;
  for (const Json& result : results) {
    const Json truths = truthsOf(result);
    for (const auto& [name, truth] : truths.items()) {
      Group& group = groups[{result["effect"], result["samples"], sizeOf(result), truthTitle(name, truth)}];
      ++group.views;
      group.reference += truth["reference_rms"].get<double>();
      group.technique += truth["rms"].get<double>();
    }
  }
  return groups;
}

std::string growth(double from, double to) {
  return from > 0.0 ? fmt::format("{:+.1f} %", (to / from - 1.0) * 100.0) : "-";
}

}  // namespace

std::vector<std::vector<std::string>> truthSummaryRows(const Json& report) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& [key, group] : groupsOf(report["results"])) {
    const auto& [effect, samples, size, truth] = key;
    rows.push_back({effect, std::to_string(samples), size, truth, std::to_string(group.views),
                    fmt::format("{:.4f}", group.reference / group.views),
                    fmt::format("{:.4f}", group.technique / group.views),
                    growth(group.reference, group.technique)});
  }
  if (!rows.empty())
    rows.insert(rows.begin(),
                {"effect", "samples", "size", "truth", "views", "full RMS", "mres RMS", "more"});
  return rows;
}

}  // namespace host
