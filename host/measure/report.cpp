#include "host/measure/report.h"

#include <cmath>
#include <thread>

#include "host/measure/source_commit.h"

namespace host {
namespace {

constexpr int kSchema = 1;

Json toJson(const Summary& summary) {
  return {{"median", summary.median}, {"min", summary.min}, {"max", summary.max}, {"runs", summary.runs}};
}

/// null where a run lacks that clock.
Json summaryBy(Clock clock, const std::vector<RunTime>& runs) {
  const auto times = timesBy(clock, runs);
  return times && !times->empty() ? toJson(summarize(*times)) : Json();
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
          {"non_finite", error.nonFinite},
          {"block_max", error.blocks.max},
          {"block_p99", error.blocks.percentile99},
          {"worst_place", {error.blocks.worst.x, error.blocks.worst.y}}};
}

/// By name; null if none was asked for.
Json toJson(const std::vector<TruthErrors>& truths) {
  Json json;
  for (const TruthErrors& truth : truths)
    json[truth.name] = {{truth.unit, truth.count},
                        {"pixels", truth.pixels},
                        {"rms", truth.technique.rms},
                        {"max", truth.technique.max},
                        {"reference_rms", truth.reference.rms},
                        {"reference_max", truth.reference.max}};
  return json;
}

/// In a scene in which nothing changes there is nothing that flicker could be a share of.
Json toJson(const TemporalErrors& temporal) {
  return {{"frames", temporal.frames},
          {"rms", temporal.rms},
          {"max", temporal.max},
          {"block_max", temporal.blockMax},
          {"block_p99", temporal.blockPercentile99},
          {"change_rms", temporal.techniqueChange},
          {"reference_change_rms", temporal.referenceChange},
          {"ratio", finiteOrNull(temporal.rms / temporal.referenceChange)},
          {"non_finite", temporal.nonFinite}};
}

/// What levels and the plain effect were expected to take; null where that was not measured, or there are
/// none.
Json toJson(const mres::PlanReport& plan, glm::ivec2 size) {
  if (plan.reason.empty()) return {};
  const double milliseconds = 1e-6 * size.x * size.y;  // of a nanosecond a pixel
  Json json{
      {"falls_back", plan.fallsBack}, {"reason", plan.reason}, {"levels_ms", Json()}, {"plain_ms", Json()}};
  if (!plan.costs) return json;
  json["levels_ms"] = plan.costs->levels() * milliseconds;
  json["plain_ms"] = plan.costs->plain() * milliseconds;
  return json;
}

Json clockName(Clock clock) {
  return clock == Clock::gpu ? "GL_TIME_ELAPSED" : "glFinish+steady_clock";
}

/// The same fields whatever was timed, null where it wasn't.
void addTimes(Json& result, const InterleavedTimes& times) {
  const Clock clock = trustedClock(times);
  result["time_ms"] = summaryBy(clock, times.technique);
  result["reference_time_ms"] = summaryBy(clock, times.reference);
  result["clock"] = times.technique.empty() ? Json() : clockName(clock);
  result["wall_time_ms"] = summaryBy(Clock::wall, times.technique);
  result["reference_wall_time_ms"] = summaryBy(Clock::wall, times.reference);
  result["gpu_time_ms"] = summaryBy(Clock::gpu, times.technique);
  result["reference_gpu_time_ms"] = summaryBy(Clock::gpu, times.reference);
  result["speedup"] = Json();
  result["speedup_interval"] = Json();
  if (times.technique.empty() || times.reference.empty()) return;
  const RatioEstimate speedup = speedupOf(times);
  result["speedup"] = speedup.ratio;
  result["speedup_interval"] = {speedup.low, speedup.high};
}

/// Pixels in which the effect ran, for each of the full resolution.
std::optional<double> knownWork(const Measurement& measurement) {
  const std::vector<double>& coverage = measurement.coverage;
  if (coverage.empty()) return measurement.work;
  double work = 0.0;
  for (std::size_t level = 0; level < coverage.size(); ++level)
    work += std::ldexp(coverage[level], -2 * static_cast<int>(level));
  return work;
}

/// The floor is what the levels alone would take at the reference's cost per pixel, their filters included:
/// masks, stencils and blends are what comes on top. Null where nothing was timed or no work is known.
void addEfficiency(Json& result, std::optional<double> work) {
  const bool isTimed = work && !result["speedup"].is_null();
  result["work"] = work ? Json(*work) : Json();
  result["floor_ms"] = isTimed ? Json(result["reference_time_ms"]["median"].get<double>() * *work) : Json();
  result["efficiency"] = isTimed ? Json(result["speedup"].get<double>() * *work) : Json();
}

}  // namespace

Machine machineOf(const std::string& renderer, const std::string& version) {
  return {renderer, version, static_cast<int>(std::thread::hardware_concurrency())};
}

Json toJson(const Measurement& measurement) {
  Json result{{"scene", measurement.scene},        {"triangles", measurement.triangles},
              {"camera", measurement.camera},      {"camera_name", measurement.cameraName},
              {"width", measurement.size.x},       {"height", measurement.size.y},
              {"effect", measurement.effect},      {"samples", measurement.samples},
              {"technique", measurement.technique}};
  result["reference"] = measurement.reference ? Json(*measurement.reference) : Json();
  result["reference_samples"] = measurement.referenceSamples.value_or(measurement.samples);
  addTimes(result, measurement.times.value_or(InterleavedTimes()));
  result["error"] = measurement.error ? toJson(*measurement.error) : Json();
  result["truth"] = toJson(measurement.truths);
  result["temporal"] = measurement.temporal ? toJson(*measurement.temporal) : Json();
  result["coverage"] = measurement.coverage;
  addEfficiency(result, knownWork(measurement));
  result["stages_ms"] = Json::object();
  for (const StageCost& stage : measurement.stages) result["stages_ms"][stage.name] = stage.milliseconds;
  result["stages_clock"] = measurement.stages.empty() ? Json() : Json(measurement.stagesClock);
  result["skipped"] = Json::array();
  for (const SkippedPart& part : measurement.skipped)
    result["skipped"].push_back({{"what", part.what}, {"reason", part.reason}});
  result["plan"] = toJson(measurement.plan, measurement.size);
  result["gpu_bytes"] = measurement.gpuBytes;
  result["seconds"] = measurement.seconds;
  result["settings"] = measurement.settings;
  result["pictures"] = measurement.pictures;
  result["warnings"] = measurement.warnings;
  return result;
}

Json makeReport(const Machine& machine) {
  return {
      {"schema", kSchema},
      {"version", MRES_VERSION},
      {"commit", sourceCommit()},
      {"machine", {{"renderer", machine.renderer}, {"version", machine.version}, {"cores", machine.cores}}},
      {"results", Json::array()}};
}

std::string toText(const Json& report) {
  return report.dump(2) + "\n";
}

}  // namespace host
