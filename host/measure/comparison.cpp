#include "host/measure/comparison.h"

#include <fmt/format.h>

#include "host/measure/error_metrics.h"
#include "host/measure/gl_timer.h"

namespace host {
namespace {

constexpr mres::Technique kReference = mres::Technique::full;
constexpr double kShareOfTiming = 0.85;  // of the whole work, about

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

Comparison::Comparison(const Scene& scene, const PictureSettings& settings, bool softwareRasterizer)
    : scene_(scene),
      settings_(settings),
      softwareRasterizer_(softwareRasterizer),
      renderer_(scene, profiler_, rendererSettings(settings)),
      technique_(settings, settings.technique, EffectInstance::Coverage::unmeasured),
      reference_(settings, kReference, EffectInstance::Coverage::unmeasured),
      inspected_(settings, settings.technique, EffectInstance::Coverage::measured) {}

/// By both techniques, timed if that was asked for.
void Comparison::render(const ComparisonRequest& request, Measurement& measurement,
                        const WorkObserver& observe) {
  const Work renderTechnique = [this] { techniqueTexture_ = technique_.render(frame_); };
  const Work renderReference = [this] { referenceTexture_ = reference_.render(frame_); };
  if (request.timing) {
    const GlTimer timer(softwareRasterizer_);
    measurement.times = timeInterleaved(
        renderTechnique, renderReference, [&timer](const Work& work) { return timer(work); }, *request.timing,
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

Measurement Comparison::measure(const ComparisonRequest& request, const WorkObserver& observe) {
  const GBufferTextures& gbuffer = renderer_.drawGeometry(scene_.cameras.at(request.camera), request.size);
  frame_ = frameOf(renderer_, gbuffer, request.size);
  inputs_ = drawInputs(renderer_, settings_);
  for (EffectInstance* instance : {&technique_, &reference_, &inspected_}) instance->setInputs(inputs_);

  Measurement measurement = describePicture(scene_, settings_, request.camera, request.size);
  measurement.reference = nameOf(kReference);
  measurement.warnings = warnings();
  render(request, measurement, observe);
  observe(kShareOfTiming, "comparing the pictures");
  techniqueValues_ = readTexture(techniqueTexture_, request.size, technique_.channels());
  referenceValues_ = readTexture(referenceTexture_, request.size, reference_.channels());
  measurement.error = compareImages(techniqueValues_, referenceValues_);
  observe(kShareOfTiming, "looking at each stage");
  inspect(inspected_, frame_, request.timing ? stageClockOf(softwareRasterizer_) : StageClock::off,
          measurement);
  if (request.truth) measurement.truths = compareWithTruths(observe);
  return measurement;
}

/// Of the values read back.
std::vector<TruthErrors> Comparison::compareWithTruths(const WorkObserver& observe) {
  if (!truthFinder_) truthFinder_ = std::make_unique<TruthFinder>(scene_, settings_);
  const auto observeRest = [&observe](double share, const std::string& what) {
    observe(kShareOfTiming + (1.0 - kShareOfTiming) * share, what);
  };
  std::vector<TruthErrors> errors;
  for (const Truth& truth : truthFinder_->find(frame_, inputs_, observeRest))
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
  const auto debugView = [this](mres::DebugView view) {
    return readTexture(technique_.multiResolution().debugView(view), frame_.size, 3);
  };
  pictures.edges = debugView(mres::DebugView::edges);
  pictures.levels = debugView(mres::DebugView::levels);
  return pictures;
}

}  // namespace host
