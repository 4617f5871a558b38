#include "host/commands/bench_results.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "host/commands/output.h"
#include "host/measure/report_check.h"

namespace host {
namespace {

/// The fields that tell one picture from another.
constexpr std::array kIdentity{"scene", "camera", "width", "height", "effect", "technique", "settings"};

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
  throw std::runtime_error(
      fmt::format("Cannot resume from '{}': {}; leave out --resume to begin anew.", file.string(), reason));
}

Json readReport(const std::filesystem::path& file, const Json& empty) {
  std::ifstream stream(file);
  Json report = Json::parse(stream, nullptr, false);
  if (const std::string fault = faultOf(report); !fault.empty()) refuse(file, fault);
  if (report.at("machine") != empty.at("machine")) refuse(file, "it was measured on another machine");
  if (report.at("version") != empty.at("version"))
    refuse(file,
           fmt::format("it was measured by mres {}, and this is {}", report.at("version").get<std::string>(),
                       empty.at("version").get<std::string>()));
  if (report.at("commit") != empty.at("commit"))
    refuse(file, fmt::format("it was measured at commit {}, and this is {}", report.at("commit").dump(),
                             empty.at("commit").dump()));
  return report;
}

/// The UTC day.
std::string today() {
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)));
}

bool isSamePicture(const Json& a, const Json& b) {
  return std::ranges::all_of(kIdentity, [&](const char* field) { return a.at(field) == b.at(field); });
}

bool has(const Json& result, WantedParts parts) {
  return !(parts.times && result.at("speedup").is_null()) && !(parts.truth && truthsOf(result).is_null());
}

}  // namespace

BenchResults::BenchResults(std::filesystem::path file, const Machine& machine, bool resume)
    : file_(std::move(file)), report_(makeReport(machine)) {
  report_["date"] = today();
  std::error_code ignored;  // a file that cannot be looked at cannot be replaced either, which is told then
  if (resume && std::filesystem::exists(file_, ignored)) report_ = readReport(file_, report_);
}

bool BenchResults::contains(const Measurement& wanted, WantedParts parts) const {
  const Json description = toJson(wanted);
  return std::ranges::any_of(report_.at("results"), [&](const Json& result) {
    return isSamePicture(result, description) && has(result, parts);
  });
}

void BenchResults::add(const Measurement& measurement) {
  auto& results = report_.at("results").get_ref<Json::array_t&>();
  Json result = toJson(measurement);
  std::erase_if(results, [&](const Json& old) { return isSamePicture(old, result); });
  results.push_back(std::move(result));
  writeTextFile(file_, toText(report_));
}

}  // namespace host
