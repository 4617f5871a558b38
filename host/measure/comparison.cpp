#include "host/measure/comparison.h"

#include <fmt/format.h>
#include <utility>

#include "host/measure/error_metrics.h"
#include "host/measure/gl_timer.h"

namespace host {
namespace {

constexpr const char* kReference = kFullTechnique;
constexpr double kShareOfTiming = 0.85;  // of the work on a view, about
constexpr double kShareOfPath = 0.5;     // of the whole work, about, where there is one

TruthErrors errorsAgainst(const Truth& truth, const FloatImage& technique, const FloatImage& reference) {
  const glm::ivec2 pixels = truth.grid.size();
  return {.name = truth.name,
          .unit = truth.unit,
          .count = truth.count,
          .pixels = static_cast<std::size_t>(pixels.x) * static_cast<std::size_t>(pixels.y),
          .technique = compareValues(valuesAt(truth.grid, technique), truth.values),
          .reference = compareValues(valuesAt(truth.grid, reference), truth.values)};
}

}  // namespace

Comparison::Comparison(const Scene& scene, const PictureSettings& settings, const PictureSettings& reference,
                       bool softwareRasterizer)
    : scene_(scene),
      settings_(settings),
      referenceSettings_(reference),
      softwareRasterizer_(softwareRasterizer),
      renderer_(scene, profiler_, rendererSettings(settings)),
      technique_(settings, settings.technique, EffectInstance::Coverage::unmeasured),
      reference_(reference, kReference, EffectInstance::Coverage::unmeasured),
      inspected_(settings, settings.technique, EffectInstance::Coverage::measured) {}

/// The geometry, and what effects read besides.
void Comparison::draw(const Camera& camera, glm::ivec2 size) {
  const GBufferTextures& gbuffer = renderer_.drawGeometry(camera, size);
  frame_ = frameOf(renderer_, gbuffer, size);
  inputs_ = drawInputs(renderer_, settings_);
  for (EffectInstance* instance : {&technique_, &reference_, &inspected_}) instance->setInputs(inputs_);
  setCosts(std::nullopt);
}

void Comparison::setCosts(const std::optional<mres::Costs>& costs) {
  for (EffectInstance* instance : {&technique_, &inspected_}) instance->setCosts(costs);
}

/// By both techniques, timed if that was asked for.
void Comparison::render(const ComparisonRequest& request, Measurement& measurement,
                        const WorkObserver& observe) {
  if (request.timing) {
    observe(0.0, "finding out what pays");
    setCosts(technique_.calibrate(frame_));
    const GlTimer timer(softwareRasterizer_);
    measurement.times = timeInterleaved(
        [this] { renderTechnique(); }, [this] { renderReference(); },
        [&timer](const Work& work) { return timer(work); }, *request.timing,
        [&observe](int pair, int expected) {
          observe(kShareOfTiming * pair / expected,
                  pair == 0 ? "warming up" : fmt::format("timed pair {} of at most {}", pair, expected));
        });
  } else {
    observe(0.0, "rendering");
    renderTechnique();
    renderReference();
  }
}

void Comparison::readValues() {
  techniqueValues_ = readTexture(techniqueTexture_, frame_.size, technique_.channels());
  referenceValues_ = readTexture(referenceTexture_, frame_.size, reference_.channels());
}

Measurement Comparison::measure(const ComparisonRequest& request, const WorkObserver& observe) {
  if (!request.path) return measureView(request, observe);
  // First, so that what is left is the view itself, for pictures().
  const TemporalErrors temporal = measureFlicker(request, partOf(observe, 0.0, kShareOfPath));
  Measurement measurement = measureView(request, partOf(observe, kShareOfPath, 1.0));
  if (!measurement.plan.fallsBack) measurement.temporal = temporal;  // which is that of levels
  return measurement;
}

/// Along the path.
TemporalErrors Comparison::measureFlicker(const ComparisonRequest& request, const WorkObserver& observe) {
  const int frames = request.path->frames;
  const Bounds bounds = boundsOf(scene_);
  TemporalErrorSum sum;
  for (int frame = 0; frame < frames; ++frame) {
    observe(static_cast<double>(frame) / frames, fmt::format("frame {} of {}", frame + 1, frames));
    draw(cameraAt(scene_.cameras.at(request.camera), *request.path, bounds, frame), request.size);
    renderTechnique();
    renderReference();
    readValues();
    sum.add(std::move(techniqueValues_), std::move(referenceValues_));
  }
  return sum.result();
}

Measurement Comparison::measureView(const ComparisonRequest& request, const WorkObserver& observe) {
  draw(scene_.cameras.at(request.camera), request.size);
  Measurement measurement = describePicture(scene_, settings_, request.camera, request.size);
  measurement.reference = kReference;
  measurement.referenceSamples = sampleCount(referenceSettings_);
  measurement.warnings = warnings();
  render(request, measurement, observe);
  observe(kShareOfTiming, "comparing the pictures");
  readValues();
  measurement.error = compareImages(techniqueValues_, referenceValues_);
  look(request, measurement, observe);
  if (request.truth) measurement.truths = compareWithTruths(observe);
  return measurement;
}

void Comparison::look(const ComparisonRequest& request, Measurement& measurement,
                      const WorkObserver& observe) {
  if (!request.stages) {
    measurement.gpuBytes = technique_.bytes();
    measurement.plan = technique_.plan();
    return;
  }
  observe(kShareOfTiming, "looking at each stage");
  inspect(inspected_, frame_, request.timing ? stageClockOf(softwareRasterizer_) : StageClock::off,
          measurement);
}

/// Of the values read back.
std::vector<TruthErrors> Comparison::compareWithTruths(const WorkObserver& observe) {
  if (!truthFinder_) truthFinder_ = std::make_unique<TruthFinder>(scene_, referenceSettings_);
  std::vector<TruthErrors> errors;
  for (const Truth& truth : truthFinder_->find(frame_, inputs_, partOf(observe, kShareOfTiming, 1.0)))
    errors.push_back(errorsAgainst(truth, techniqueValues_, referenceValues_));
  return errors;
}

FloatImage Comparison::litBy(GLuint effect) {
  renderer_.drawLighting(screenEffects(settings_, effect));
  return readTexture(renderer_.drawToneMap(), frame_.size, 3);
}

ComparisonPictures Comparison::pictures() {
  ComparisonPictures pictures;
  pictures.reference = litBy(referenceTexture_);
  pictures.technique = litBy(techniqueTexture_);
  pictures.referenceEffect = referenceValues_;
  pictures.techniqueEffect = techniqueValues_;
  pictures.difference = differenceImage(techniqueValues_, referenceValues_, kDifferenceEnhancement);
  mres::MultiResolution* multiResolution = technique_.multiResolution();
  if (multiResolution == nullptr) return pictures;
  const auto debugView = [&](mres::DebugView view) {
    return readTexture(multiResolution->debugView(view), frame_.size, 3);
  };
  pictures.edges = debugView(mres::DebugView::edges);
  pictures.levels = debugView(mres::DebugView::levels);
  return pictures;
}

}  // namespace host
