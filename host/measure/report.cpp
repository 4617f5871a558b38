#include "host/measure/report.h"

#include <cmath>
#include <thread>

namespace host {
namespace {

constexpr int kSchema = 1;

Json toJson(const Summary& summary) {
  return {{"median", summary.median}, {"min", summary.min}, {"max", summary.max}, {"runs", summary.runs}};
}

/// null where a run lacks that clock.
Json summaryBy(Clock clock, const std::vector<RunTime>& runs) {
  const auto times = timesBy(clock, runs);
  return times ? toJson(summarize(*times)) : Json();
}

/// JSON has no infinity: equal images have a PSNR of null.
Json finiteOrNull(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json toJson(const ErrorMetrics& error) {
  return {{"rms", error.rms},
          {"max", error.max},
          {"psnr", finiteOrNull(error.psnr)},
          {"ssim", error.ssim},
          {"non_finite", error.nonFinite}};
}

/// The same fields whether or not times were taken, null where they weren't.
void addTimes(Json& result, const std::optional<InterleavedTimes>& times) {
  const std::vector<RunTime> none;
  const Clock clock = times ? trustedClock(*times) : Clock::wall;
  const auto add = [&](const char* key, Clock by, const std::vector<RunTime>& runs) {
    result[key] = times ? summaryBy(by, runs) : Json();
  };
  const std::vector<RunTime>& technique = times ? times->technique : none;
  const std::vector<RunTime>& reference = times ? times->reference : none;
  add("time_ms", clock, technique);
  add("reference_time_ms", clock, reference);
  result["clock"] = !times                ? Json()
                    : clock == Clock::gpu ? Json("GL_TIME_ELAPSED")
                                          : Json("glFinish+steady_clock");
  add("wall_time_ms", Clock::wall, technique);
  add("reference_wall_time_ms", Clock::wall, reference);
  add("gpu_time_ms", Clock::gpu, technique);
  add("reference_gpu_time_ms", Clock::gpu, reference);
  result["speedup"] = Json();
  result["speedup_interval"] = Json();
  if (!times) return;
  const RatioEstimate speedup = speedupOf(*times);
  result["speedup"] = speedup.ratio;
  result["speedup_interval"] = {speedup.low, speedup.high};
}

}  // namespace

Machine machineOf(const std::string& renderer, const std::string& version) {
  return {renderer, version, static_cast<int>(std::thread::hardware_concurrency())};
}

Json toJson(const Measurement& measurement) {
  Json result{{"scene", measurement.scene},         {"triangles", measurement.triangles},
              {"camera", measurement.camera},       {"camera_name", measurement.cameraName},
              {"width", measurement.size.x},        {"height", measurement.size.y},
              {"effect", measurement.effect},       {"samples", measurement.samples},
              {"technique", measurement.technique}, {"reference", measurement.reference}};
  addTimes(result, measurement.times);
  result["error"] = toJson(measurement.error);
  result["coverage"] = measurement.coverage;
  result["stages_ms"] = Json::object();
  for (const StageCost& stage : measurement.stages) result["stages_ms"][stage.name] = stage.milliseconds;
  result["skipped"] = Json::array();
  for (const SkippedPart& part : measurement.skipped)
    result["skipped"].push_back({{"what", part.what}, {"reason", part.reason}});
  result["gpu_bytes"] = measurement.gpuBytes;
  result["settings"] = measurement.settings;
  result["pictures"] = measurement.pictures;
  return result;
}

Json makeReport(const Machine& machine) {
  return {
      {"schema", kSchema},
      {"machine", {{"renderer", machine.renderer}, {"version", machine.version}, {"cores", machine.cores}}},
      {"results", Json::array()}};
}

std::string toText(const Json& report) {
  return report.dump(2) + "\n";
}

}  // namespace host
