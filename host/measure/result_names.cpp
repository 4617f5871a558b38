#include "host/measure/result_names.h"

#include <fmt/format.h>

#include "host/measure/techniques.h"

namespace host {

std::string viewOf(const Json& result) {
  return fmt::format("{} {}", result["scene"].get<std::string>(), result["camera"].get<int>());
}

std::string pictureOf(const Json& result) {
  return fmt::format("{} {}", viewOf(result), result["effect"].get<std::string>());
}

std::string sizeOf(const Json& result) {
  return fmt::format("{}x{}", result["width"].get<int>(), result["height"].get<int>());
}

double megapixels(const Json& result) {
  return result["width"].get<double>() * result["height"].get<double>() / 1e6;
}

std::string workOf(const Json& result) {
  return fmt::format("{}, {} samples", result["effect"].get<std::string>(), result["samples"].get<int>());
}

namespace {

/// As it came out of the settings, which are floats.
bool isDefaultBudget(const Json& budget) {
  return budget.get<float>() == mres::MaskSettings{}.errorBudget;
}

}  // namespace

std::string techniqueTitle(const Json& result) {
  auto name = result["technique"].get<std::string>();
  if (name == kFullTechnique && result["samples"] != referenceSamplesOf(result))
    return fmt::format("{}, {} samples", name, result["samples"].get<int>());
  const Json& settings = result["settings"];
  if (!heedsErrorBudget(name) || !settings.contains("errorBudget") ||
      isDefaultBudget(settings["errorBudget"]))
    return name;
  return fmt::format("{}, budget {}", name, settings["errorBudget"].get<float>());
}

int referenceSamplesOf(const Json& result) {
  return result.value("reference_samples", result["samples"]).get<int>();
}

std::string durationOf(const Json& report) {
  constexpr double kMinute = 60.0;
  double seconds = 0.0;
  for (const Json& result : report["results"]) seconds += result.value("seconds", 0.0);
  if (seconds == 0.0) return "";
  return seconds < 2.0 * kMinute ? fmt::format("{:.0f} seconds", seconds)
                                 : fmt::format("{:.0f} minutes", seconds / kMinute);
}

}  // namespace host
