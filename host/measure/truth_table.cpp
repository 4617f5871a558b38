// Errors against truth for people: one row a picture and truth.
#include <fmt/format.h>

#include "host/measure/report.h"
#include "host/measure/result_names.h"
#include "host/measure/text_table.h"

namespace host {
namespace {

std::string number(const Json& truth, const char* key) {
  return fmt::format("{:.4f}", truth[key].get<double>());
}

std::vector<std::string> rowOf(const Json& result, const std::string& name, const Json& truth) {
  return {pictureOf(result),      truthTitle(name, truth),
          truth["pixels"].dump(), number(truth, "reference_rms"),
          number(truth, "rms"),   number(truth, "reference_max"),
          number(truth, "max")};
}

}  // namespace

Json truthsOf(const Json& result) {
  return result.value("truth", Json());
}

std::string truthTitle(const std::string& name, const Json& truth) {
  const char* unit = truth.contains("rays") ? "rays" : "samples";
  return fmt::format("{}, {} {}", name == "ray_traced" ? "ray traced" : name, truth[unit].dump(), unit);
}

std::string toTruthTable(const Json& report) {
  std::vector<std::vector<std::string>> rows{
      {"scene camera effect", "truth", "pixels", "full RMS", "RMS", "full max", "max"}};
  for (const Json& result : report["results"]) {
    const Json truths = truthsOf(result);
    for (const auto& [name, truth] : truths.items()) rows.push_back(rowOf(result, name, truth));
  }
  if (rows.size() == 1) return {};
  return "\nError against truth:\n" + formatTable(rows);
}

}  // namespace host
