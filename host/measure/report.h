// The report that scripts rely on: one JSON object, as the page on the command line has it. Fields are added
// over time, never renamed.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/measure/error_metrics.h"
#include "host/measure/interleaved.h"

namespace host {

using Json = nlohmann::ordered_json;

struct Machine {
  std::string renderer;
  std::string version;
  int cores = 0;
};

/// This process's cores and the current context's driver.
Machine machineOf(const std::string& renderer, const std::string& version);

struct StageCost {
  std::string name;
  double milliseconds = 0.0;
};

struct SkippedPart {
  std::string what;
  std::string reason;
};

/// What was measured of one picture.
struct Measurement {
  std::string scene;
  std::size_t triangles = 0;
  int camera = 0;
  std::string cameraName;
  glm::ivec2 size{0};
  std::string effect;
  int samples = 0;
  std::string technique;
  std::string reference;
  Json settings;                          ///< every setting that the picture depends on
  std::optional<InterleavedTimes> times;  ///< none if pictures and errors alone were asked for
  ErrorMetrics error;
  std::vector<double> coverage;   ///< finest level first
  std::vector<StageCost> stages;  ///< of the technique
  std::vector<SkippedPart> skipped;
  std::size_t gpuBytes = 0;
  Json pictures = Json::object();  ///< what a picture shows -> its file, relative to the report
};

Json toJson(const Measurement& measurement);

/// A report without results yet.
Json makeReport(const Machine& machine);

/// JSON as it is written to files and to stdout.
std::string toText(const Json& report);

/// The report as a table for people, with a last row of means where there are several results.
std::string toTable(const Json& report);

}  // namespace host
