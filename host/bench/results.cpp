#include "host/bench/results.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "host/console/notes.h"
#include "host/console/output.h"
#include "host/measure/report_check.h"
#include "host/measure/result_names.h"

namespace host {
namespace fs = std::filesystem;
namespace {

/// The fields that tell one picture from another, and scenes of the same name.
constexpr std::array kIdentity{"scene",  "triangles", "camera",    "camera_name", "width",
                               "height", "effect",    "technique", "settings"};

Json parse(const fs::path& file) {
  std::ifstream stream(file);
  return Json::parse(stream, nullptr, false);
}

/// Why `report` cannot be gone on with by what makes `empty` reports; nothing if it can.
std::string obstacleOf(const Json& report, const Json& empty) {
  if (std::string fault = faultOf(report); !fault.empty()) return fault;
  if (report.at("machine") != empty.at("machine")) return "it was measured on another machine";
  if (report.at("version") != empty.at("version"))
    return fmt::format("it was measured by mres {}, and this is {}", report.at("version").get<std::string>(),
                       empty.at("version").get<std::string>());
  if (report.at("commit") != empty.at("commit"))
    return fmt::format("it was measured at commit {}, and this is {}", report.at("commit").dump(),
                       empty.at("commit").dump());
  return "";
}

Json resumedFrom(const fs::path& file, const Json& empty) {
  Json report = parse(file);
  if (const std::string obstacle = obstacleOf(report, empty); !obstacle.empty())
    throw std::runtime_error(fmt::format("Cannot resume from '{}': {}; leave out --resume to begin anew.",
                                         file.string(), obstacle));
  return report;
}

/// The first that is free of results.previous.json, results.previous-2.json, ...
fs::path freeNameFor(const fs::path& file) {
  fs::path name = fs::path(file).replace_extension(".previous.json");
  for (int number = 2; fs::exists(name); ++number)
    name = fs::path(file).replace_extension(fmt::format(".previous-{}.json", number));
  return name;
}

/// Hours of measuring are not to be lost for a forgotten --resume.
void setAside(const fs::path& file) {
  const fs::path previous = freeNameFor(file);
  std::error_code error;
  fs::rename(file, previous, error);
  if (error)
    throw std::runtime_error(fmt::format("Cannot keep '{}' as '{}': {}; choose another place with -o.",
                                         file.string(), previous.string(), error.message()));
  fmt::print(stderr, "mres: The results that were there are kept as '{}'.\n", previous.string());
}

/// The UTC day.
std::string today() {
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)));
}

bool isSamePicture(const Json& a, const Json& b) {
  return std::ranges::all_of(kIdentity, [&](const char* field) { return a.at(field) == b.at(field); }) &&
         referenceSamplesOf(a) == referenceSamplesOf(b);
}

/// Of a view that the plain effect rendered, flicker is not measured.
bool fellBack(const Json& result) {
  const Json plan = result.value("plan", Json());
  return !plan.is_null() && plan.at("falls_back").get<bool>();
}

bool has(const Json& result, WantedParts parts) {
  return !(parts.times && result.at("speedup").is_null()) && !(parts.truth && truthsOf(result).is_null()) &&
         !(parts.temporal && result.value("temporal", Json()).is_null() && !fellBack(result));
}

}  // namespace

Json readResults(const fs::path& file) {
  std::error_code ignored;  // what cannot be looked at cannot be read
  const bool isThere = fs::exists(file, ignored);
  Json report = parse(file);
  if (const std::string fault = isThere ? faultOf(report) : "there is no such file"; !fault.empty())
    throw std::runtime_error(fmt::format("Cannot report from '{}': {}; leave out --report to measure anew.",
                                         file.string(), fault));
  return report;
}

std::vector<std::string> notesOfResuming(const std::string& commit) {
  if (!commit.ends_with('+')) return {};
  return {
      fmt::format("Files were changed since commit {}: whether the results that were there are of the "
                  "same changes is not known.",
                  commit.substr(0, commit.size() - 1))};
}

BenchResults::BenchResults(fs::path file, const Machine& machine, bool resume)
    : file_(std::move(file)), report_(makeReport(machine)) {
  report_["date"] = today();
  std::error_code ignored;  // a file that cannot be looked at cannot be replaced either, which is told then
  if (!fs::exists(file_, ignored)) return;
  if (!resume) {
    setAside(file_);
    return;
  }
  report_ = resumedFrom(file_, report_);
  writeNotes(std::cerr, notesOfResuming(report_.at("commit").get<std::string>()));
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
