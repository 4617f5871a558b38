#include "host/bench/campaign.h"

#include <fmt/format.h>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "host/bench/cost.h"
#include "host/console/interruption.h"
#include "host/console/memory_need.h"
#include "host/console/notes.h"
#include "host/console/options.h"
#include "host/console/output.h"
#include "host/measure/picture_files.h"

namespace host {
namespace fs = std::filesystem;
namespace {

// Of the time of a case, about.
constexpr double kShareOfMeasuring = 0.95;

const RepeatPlan kUntimed{.pairs = 1, .warmUpSeconds = 0.0};  // each technique draws once

PictureSettings settingsOf(const BenchCase& benchCase) {
  PictureSettings settings;
  settings.effect = benchCase.effect;
  settings.technique = benchCase.technique;
  settings.mask.errorBudget = benchCase.errorBudget;
  settingsTable(settings).set({"samples", std::to_string(benchCase.samples)});
  return settings;
}

PictureSettings referenceSettingsOf(const BenchCase& benchCase) {
  BenchCase reference = benchCase;
  reference.samples = referenceSamplesOf(benchCase);
  return settingsOf(reference);
}

ComparisonRequest requestOf(const BenchCase& benchCase, const std::optional<RepeatPlan>& timing) {
  ComparisonRequest request{benchCase.camera, benchCase.size, timing, benchCase.truth};
  if (benchCase.frames > 0) request.path = CameraPath{.frames = benchCase.frames};
  request.stages = benchCase.stages;
  return request;
}

void requireMemoryFor(const BenchCase& benchCase, const PictureSettings& settings) {
  const PictureNeed need = needOf(settings, benchCase.size);
  requireMemory(benchCase.truth ? bytesOfComparisonWithTruth(need) : bytesOfComparison(need),
                availableMemory(), "they are left out");
}

fs::path pictureFolderOf(const BenchCase& benchCase) {
  return fs::path("pictures") /
         fmt::format("{}-{}-{}", benchCase.scene.name, benchCase.camera, benchCase.effect);
}

}  // namespace

Campaign::Campaign(CampaignRequest request, const GlContext::Info& gl)
    : request_(std::move(request)),
      results_(request_.output / "results.json", machineOf(gl.renderer, gl.version), request_.resume),
      workbench_(gl.software) {
  for (const BenchCase& benchCase : request_.cases) totalSeconds_ += expectedSeconds(benchCase);
}

double Campaign::expectedSeconds(const BenchCase& benchCase) const {
  return secondsOf(benchCase, request_.timing.value_or(kUntimed));
}

const Json& Campaign::run() {
  for (const BenchCase& benchCase : request_.cases) runCase(benchCase);
  progress_.clear();
  return results_.report();
}

std::vector<std::string> Campaign::incompleteScenes() const {
  std::vector<std::string> names;
  for (const auto& [scene, reasons] : leftOut_) names.push_back(scene);
  return names;
}

void Campaign::runCase(const BenchCase& benchCase) {
  const Stopwatch stopwatch;
  if (std::optional<Measurement> measurement = measure(benchCase)) {
    measurement->seconds = stopwatch.elapsed().count();
    results_.add(*measurement);
  } else {
    timeLeft_.skip(expectedSeconds(benchCase) / totalSeconds_);
  }
  doneSeconds_ += expectedSeconds(benchCase);
}

const Scene* Campaign::load(const BenchCase& benchCase) {
  if (brokenScenes_.contains(benchCase.scene.source)) return nullptr;
  show(0.0, benchCase, "loading");
  try {
    return &workbench_.scene(benchCase.scene);
  } catch (const std::runtime_error& error) {
    leaveOut(benchCase, error.what());
    brokenScenes_.insert(benchCase.scene.source);
    return nullptr;
  }
}

std::optional<Measurement> Campaign::measure(const BenchCase& benchCase) {
  const Scene* scene = load(benchCase);
  if (!scene || benchCase.camera >= static_cast<int>(scene->cameras.size())) return std::nullopt;
  PictureSettings settings = settingsOf(benchCase);
  Measurement wanted = describePicture(*scene, settings, benchCase.camera, benchCase.size);
  wanted.settings = settingsTable(settings).values();
  wanted.referenceSamples = referenceSamplesOf(benchCase);
  const WantedParts parts{request_.timing.has_value(), benchCase.truth, benchCase.frames > 0};
  if (results_.contains(wanted, parts)) return std::nullopt;
  try {
    return measure(benchCase, settings, wanted.settings);
  } catch (const std::runtime_error& error) {
    leaveOut(benchCase, error.what());
    return std::nullopt;
  }
}

Measurement Campaign::measure(const BenchCase& benchCase, const PictureSettings& settings,
                              const Json& values) {
  requireMemoryFor(benchCase, settings);
  Comparison& comparison = workbench_.comparison(settings, referenceSettingsOf(benchCase), values);
  noteOnce(benchCase, comparison);
  Measurement measurement = comparison.measure(
      requestOf(benchCase, request_.timing),
      [&](double share, const std::string& what) { show(kShareOfMeasuring * share, benchCase, what); });
  measurement.settings = values;
  measurement.pictures = writeCasePictures(benchCase, comparison, measurement.error->blocks.worst);
  return measurement;
}

Json Campaign::writeCasePictures(const BenchCase& benchCase, Comparison& comparison, glm::ivec2 worstPlace) {
  if (!benchCase.pictures && !benchCase.worstPlace) return Json::object();
  show(kShareOfMeasuring, benchCase, "writing pictures");
  const fs::path folder = pictureFolderOf(benchCase);
  const OutputDirectory directory(request_.output / folder);
  const ComparisonPictures shown = comparison.pictures();
  Json pictures = Json::object();
  if (benchCase.pictures) pictures.update(writePictures(shown, directory.path()));
  if (benchCase.worstPlace) pictures.update(writeWorstPlace(shown, worstPlace, directory.path()));
  return picturesBelow(folder, pictures);
}

/// Of a scene, whose cases come one after the other.
void Campaign::noteOnce(const BenchCase& benchCase, const Comparison& comparison) {
  if (std::exchange(notedScene_, benchCase.scene.name) == benchCase.scene.name) return;
  std::vector<std::string> notes = comparison.warnings();
  for (std::string& note : notes) note.insert(0, benchCase.scene.name + ": ");
  progress_.clear();
  writeNotes(std::cerr, notes);
}

void Campaign::leaveOut(const BenchCase& benchCase, const std::string& reason) {
  if (!leftOut_[benchCase.scene.name].insert(reason).second) return;
  progress_.clear();
  fmt::print(stderr, "mres: {}: {}\n", nameOf(benchCase), asSentence(reason));
}

void Campaign::show(double shareOfCase, const BenchCase& benchCase, const std::string& what) {
  throwIfInterrupted();
  const double share = (doneSeconds_ + shareOfCase * expectedSeconds(benchCase)) / totalSeconds_;
  const auto left = timeLeft_.at(share, stopwatch_.elapsed());
  progress_.update(share,
                   fmt::format("{}{}: {}", left ? describe(*left) + ", " : "", nameOf(benchCase), what));
}

}  // namespace host
