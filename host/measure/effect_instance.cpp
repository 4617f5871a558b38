#include "host/measure/effect_instance.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "host/image/image_file.h"
#include "host/measure/statistics.h"
#include "host/peers/peer_kinds.h"

namespace host {
namespace {

// More frames make a steadier median; slow frames vary less, so few of them will do.
constexpr int kMostInspectedFrames = 3;
constexpr double kEnoughInspectedMs = 1000.0;
constexpr int kQueryLatency = 4;  // frames until the profiler reads queries; it never waits for them

std::string stageName(std::string_view scope) {
  constexpr std::string_view kPrefix = "mres.";
  if (scope.starts_with(kPrefix)) scope.remove_prefix(kPrefix.size());
  return std::string(scope);
}

/// The stages of one frame, those of the same name added up.
std::vector<StageCost> stagesOf(const std::vector<mres::gl::StageTime>& times) {
  std::vector<StageCost> stages;
  for (const mres::gl::StageTime& time : times) {
    const std::string name = stageName(time.name);
    const auto known = std::ranges::find(stages, name, &StageCost::name);
    if (known == stages.end())
      stages.push_back({name, time.milliseconds});
    else
      known->milliseconds += time.milliseconds;
  }
  return stages;
}

/// By level index, 0 for levels that were left out.
std::vector<double> coverageOf(const mres::Report& report) {
  std::vector<double> coverage;
  for (const mres::LevelReport& level : report.levels) {
    coverage.resize(std::max<std::size_t>(coverage.size(), level.index + 1));
    coverage[level.index] = level.coverage;
  }
  return coverage;
}

/// Stage by stage the median of several frames, in the order of the first.
std::vector<StageCost> medianStages(const std::vector<std::vector<StageCost>>& frames) {
  std::map<std::string, std::vector<double>> times;
  for (const auto& frame : frames)
    for (const StageCost& stage : frame) times[stage.name].push_back(stage.milliseconds);
  std::vector<StageCost> stages = frames.front();
  for (StageCost& stage : stages) stage.milliseconds = median(times[stage.name]);
  return stages;
}

mres::MultiResolution makeMultiResolution(const PictureSettings& settings, const TechniqueChoice& technique,
                                          EffectInstance::Coverage coverage) {
  mres::Options options;
  options.shaderDirectory = settings.renderer.shaderDirectory;
  options.measureCoverage = coverage == EffectInstance::Coverage::measured;
  mres::MultiResolution multiResolution(options);
  multiResolution.settings().technique = technique.own.value();
  multiResolution.settings().plan = settings.plan;
  multiResolution.settings().mask = settings.mask;
  if (technique.minMaxMips) {
    multiResolution.settings().mask.minMaxMips = true;
    multiResolution.settings().plan.fallBack = false;  // it is there for comparison
  }
  return multiResolution;
}

PeerOptions peerOptions(const PictureSettings& settings, EffectInstance::Coverage coverage) {
  return {.shaderDirectory = settings.renderer.shaderDirectory,
          .errorBudget = settings.mask.errorBudget,
          .measureWork = coverage == EffectInstance::Coverage::measured};
}

/// From the first channel of a picture.
mres::gl::Texture2D importanceTexture(const std::string& file) {
  if (file.empty()) return {};
  const FloatImage image = readImage(file);
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(image.size.x) * static_cast<std::size_t>(image.size.y));
  for (int row = image.size.y - 1; row >= 0; --row)
    for (int column = 0; column < image.size.x; ++column)
      values.push_back(
          image.pixels[static_cast<std::size_t>((row * image.size.x + column) * image.channels)]);
  return {GL_R32F, image.size, "host.importance", 1, values.data()};
}

/// The stages of a few frames.
std::vector<std::vector<StageCost>> inspectFrames(EffectInstance& instance, const mres::Frame& frame) {
  std::vector<std::vector<StageCost>> frames;
  double spentMs = 0.0;
  do {
    instance.render(frame);
    glFinish();  // or the next frames would find that queries are not ready, and drop them
    frames.push_back(stagesOf(instance.stages()));
    for (const StageCost& stage : frames.back()) spentMs += stage.milliseconds;
  } while (frames.size() < kMostInspectedFrames && spentMs < kEnoughInspectedMs);
  return frames;
}

void timeStages(EffectInstance& instance, const mres::Frame& frame, StageClock clock,
                Measurement& measurement) {
  const bool byQueries = clock == StageClock::query;
  instance.setProfiling(clock);
  for (int i = 0; byQueries && i < kQueryLatency; ++i) {
    instance.render(frame);
    glFinish();
  }
  measurement.stages = medianStages(inspectFrames(instance, frame));
  measurement.stagesClock = byQueries ? "GL_TIMESTAMP" : "glFinish+steady_clock";
  instance.setProfiling(StageClock::off);
}

}  // namespace

StageClock stageClockOf(bool softwareRasterizer) {
  return softwareRasterizer ? StageClock::finish : StageClock::query;
}

EffectInstance::EffectInstance(const PictureSettings& settings, const std::string& technique,
                               Coverage coverage)
    : effect_(makeEffect(settings)), importance_(importanceTexture(settings.importance)) {
  if (const TechniqueChoice& choice = techniqueOf(technique); choice.own)
    multiResolution_.emplace(makeMultiResolution(settings, choice, coverage));
  else
    peer_ = makePeer(technique, effect_->description(), peerOptions(settings, coverage));
}

GLuint EffectInstance::render(mres::Frame frame) {
  frame.importance = importance_.id();
  return peer_ ? peer_->render(*effect_, frame) : multiResolution_->render(*effect_, frame);
}

void EffectInstance::setProfiling(StageClock clock) {
  if (peer_)
    peer_->setProfiling(clock);
  else
    multiResolution_->setProfiling(clock);
}

const std::vector<mres::gl::StageTime>& EffectInstance::stages() const {
  return peer_ ? peer_->stages() : multiResolution_->report().stages;
}

std::size_t EffectInstance::bytes() const {
  return peer_ ? peer_->bytes() + effect_->bytes() : multiResolution_->report().bytes;
}

mres::PlanReport EffectInstance::plan() const {
  return peer_ ? mres::PlanReport() : multiResolution_->report().plan;
}

void EffectInstance::describe(Measurement& measurement) const {
  measurement.gpuBytes = bytes();
  measurement.plan = plan();
  if (peer_) {
    measurement.work = peer_->work();
    return;
  }
  const mres::Report& report = multiResolution_->report();
  measurement.coverage = coverageOf(report);
  for (const mres::Skip& skip : report.skipped)
    measurement.skipped.push_back({std::string(skip.what), std::string(skip.reason)});
}

std::optional<mres::Costs> EffectInstance::calibrate(mres::Frame frame) {
  if (!mayFallBack()) return std::nullopt;
  frame.importance = importance_.id();
  return multiResolution_->calibrate(*effect_, frame);
}

void EffectInstance::setCosts(const std::optional<mres::Costs>& costs) {
  if (multiResolution_) multiResolution_->setCosts(*effect_, costs);
}

bool EffectInstance::mayFallBack() {
  if (peer_) return false;
  const mres::Settings& settings = multiResolution_->settings();
  return settings.technique == mres::Technique::multiResolution && settings.plan.fallBack;
}

mres::Frame frameOf(const Renderer& renderer, const GBufferTextures& gbuffer, glm::ivec2 size) {
  mres::Frame frame;
  frame.depth = gbuffer.depth;
  frame.normals = gbuffer.geometricNormal;
  frame.size = size;
  frame.view = renderer.view();
  frame.projection = renderer.projection();
  return frame;
}

void inspect(EffectInstance& instance, const mres::Frame& frame, StageClock clock, Measurement& measurement) {
  // Two frames at least: the first compiles the variants that measuring needs, and its coverage is known once
  // it is finished and the next begins.
  instance.render(frame);
  glFinish();
  if (clock == StageClock::off)
    instance.render(frame);
  else
    timeStages(instance, frame, clock, measurement);
  instance.describe(measurement);
}

}  // namespace host
