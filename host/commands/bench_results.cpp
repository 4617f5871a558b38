#include "host/commands/bench_results.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "host/commands/output.h"

namespace host {
namespace {

/// The fields that tell one picture from another.
constexpr std::array kIdentity{"scene", "camera", "width", "height", "effect", "technique", "settings"};

bool isReport(const Json& report, const Json& empty) {
  if (!report.is_object() || report.value("schema", 0) != empty["schema"].get<int>()) return false;
  const Json results = report.value("results", Json());
  return results.is_array() &&
         std::ranges::all_of(results, [](const Json& result) { return result.is_object(); });
}

Json readReport(const std::filesystem::path& file, const Json& empty) {
  std::ifstream stream(file);
  Json report = Json::parse(stream, nullptr, false);
  if (!isReport(report, empty))
    throw std::runtime_error(
        fmt::format("'{}' is no report to resume from; leave out --resume to begin anew.", file.string()));
  if (report.value("machine", Json()) != empty["machine"])
    throw std::runtime_error(
        fmt::format("'{}' was measured on another machine; resume there, or leave out --resume "
                    "to begin anew.",
                    file.string()));
  return report;
}

}  // namespace

BenchResults::BenchResults(std::filesystem::path file, const Machine& machine, bool resume)
    : file_(std::move(file)), report_(makeReport(machine)) {
  if (resume && std::filesystem::exists(file_)) report_ = readReport(file_, report_);
}

bool BenchResults::contains(const Measurement& wanted) const {
  const Json description = toJson(wanted);
  return std::ranges::any_of(report_["results"], [&](const Json& result) {
    return std::ranges::all_of(
        kIdentity, [&](const char* field) { return result.value(field, Json()) == description[field]; });
  });
}

void BenchResults::add(const Measurement& measurement) {
  report_["results"].push_back(toJson(measurement));
  writeTextFile(file_, toText(report_));
}

}  // namespace host
