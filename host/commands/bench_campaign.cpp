#include "host/commands/bench_campaign.h"

#include <fmt/format.h>
#include <stdexcept>
#include <utility>

#include "host/commands/bench_cost.h"
#include "host/commands/interruption.h"
#include "host/commands/memory_need.h"
#include "host/commands/options.h"
#include "host/commands/output.h"
#include "host/measure/picture_files.h"

namespace host {
namespace fs = std::filesystem;
namespace {

// Of the time of a case, about.
constexpr double kShareOfMeasuring = 0.95;

const RepeatPlan kUntimed{.pairs = 1};  // each technique draws once

PictureSettings settingsOf(const BenchCase& benchCase) {
  PictureSettings settings;
  settings.effect = benchCase.effect;
  settingsTable(settings).set({"samples", std::to_string(benchCase.samples)});
  return settings;
}

std::uint64_t bytesNeededBy(const BenchCase& benchCase) {
  return benchCase.truth ? bytesOfComparisonWithTruth(benchCase.size) : bytesOfComparison(benchCase.size);
}

fs::path pictureFolderOf(const BenchCase& benchCase) {
  return fs::path("pictures") /
         fmt::format("{}-{}-{}", benchCase.scene.name, benchCase.camera, benchCase.effect);
}

}  // namespace

std::optional<RepeatPlan> CampaignTiming::planOf(const BenchCase& benchCase) const {
  if (!timing) return std::nullopt;
  RepeatPlan plan = host::planOf(benchCase);
  plan.pairs = pairs;
  return plan;
}

Campaign::Campaign(CampaignRequest request, const GlContext::Info& gl)
    : request_(std::move(request)),
      results_(request_.output / "results.json", machineOf(gl.renderer, gl.version), request_.resume),
      workbench_(gl.software) {
  for (const BenchCase& benchCase : request_.cases) totalSeconds_ += expectedSeconds(benchCase);
}

double Campaign::expectedSeconds(const BenchCase& benchCase) const {
  return secondsOf(benchCase, request_.timing.planOf(benchCase).value_or(kUntimed));
}

const Json& Campaign::run() {
  for (const BenchCase& benchCase : request_.cases) {
    if (!measure(benchCase)) timeLeft_.skip(expectedSeconds(benchCase) / totalSeconds_);
    doneSeconds_ += expectedSeconds(benchCase);
  }
  progress_.clear();
  return results_.report();
}

const Scene* Campaign::load(const BenchCase& benchCase) {
  if (brokenScenes_.contains(benchCase.scene.source)) return nullptr;
  try {
    show(0.0, benchCase, "loading");
    return &workbench_.scene(benchCase.scene);
  } catch (const std::runtime_error& error) {
    progress_.clear();
    fmt::print(stderr, "mres: {}\n", error.what());
    brokenScenes_.insert(benchCase.scene.source);
    return nullptr;
  }
}

bool Campaign::measure(const BenchCase& benchCase) {
  const Scene* scene = load(benchCase);
  if (!scene || benchCase.camera >= static_cast<int>(scene->cameras.size())) return false;
  PictureSettings settings = settingsOf(benchCase);
  Measurement wanted = describePicture(*scene, settings, benchCase.camera, benchCase.size);
  wanted.settings = settingsTable(settings).values();
  if (results_.contains(wanted, {request_.timing.timing, benchCase.truth})) return false;

  requireMemory(bytesNeededBy(benchCase), availableMemory());
  Comparison& comparison = workbench_.comparison(settings, wanted.settings);
  Measurement measurement = comparison.measure(
      {benchCase.camera, benchCase.size, request_.timing.planOf(benchCase), benchCase.truth},
      [&](double share, const std::string& what) { show(kShareOfMeasuring * share, benchCase, what); });
  measurement.settings = wanted.settings;
  if (benchCase.pictures) measurement.pictures = writeCasePictures(benchCase, comparison);
  results_.add(measurement);
  return true;
}

Json Campaign::writeCasePictures(const BenchCase& benchCase, Comparison& comparison) {
  show(kShareOfMeasuring, benchCase, "writing pictures");
  const fs::path folder = pictureFolderOf(benchCase);
  const OutputDirectory directory(request_.output / folder);
  return picturesBelow(folder, writePictures(comparison.pictures(), directory.path()));
}

void Campaign::show(double shareOfCase, const BenchCase& benchCase, const std::string& what) {
  throwIfInterrupted();
  const double share = (doneSeconds_ + shareOfCase * expectedSeconds(benchCase)) / totalSeconds_;
  const auto left = timeLeft_.at(share, std::chrono::steady_clock::now() - start_);
  progress_.update(share,
                   fmt::format("{}{}: {}", left ? describe(*left) + ", " : "", nameOf(benchCase), what));
}

}  // namespace host
