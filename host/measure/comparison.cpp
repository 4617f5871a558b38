#include "host/measure/comparison.h"

#include "host/measure/error_metrics.h"
#include "host/measure/gl_timer.h"

namespace host {
namespace {

constexpr mres::Technique kReference = mres::Technique::full;

}  // namespace

Comparison::Comparison(const Scene& scene, const PictureSettings& settings, bool softwareRasterizer)
    : scene_(scene),
      settings_(settings),
      softwareRasterizer_(softwareRasterizer),
      renderer_(scene, profiler_, settings.renderer),
      technique_(settings, settings.technique, EffectInstance::Coverage::unmeasured),
      reference_(settings, kReference, EffectInstance::Coverage::unmeasured),
      inspected_(settings, settings.technique, EffectInstance::Coverage::measured) {}

Measurement Comparison::measure(const ComparisonRequest& request, const PairObserver& observe) {
  const GBufferTextures& gbuffer = renderer_.drawGeometry(scene_.cameras.at(request.camera), request.size);
  frame_ = frameOf(renderer_, gbuffer, request.size);

  Measurement measurement = describePicture(scene_, settings_, request.camera, request.size);
  measurement.reference = nameOf(kReference);
  const Work renderTechnique = [this] { techniqueTexture_ = technique_.render(frame_); };
  const Work renderReference = [this] { referenceTexture_ = reference_.render(frame_); };
  if (request.timing) {
    const GlTimer timer(softwareRasterizer_);
    measurement.times = timeInterleaved(
        renderTechnique, renderReference, [&timer](const Work& work) { return timer(work); }, *request.timing,
        observe);
  } else {
    renderTechnique();
    renderReference();
  }
  techniqueValues_ = readTexture(techniqueTexture_, request.size, 1);
  referenceValues_ = readTexture(referenceTexture_, request.size, 1);
  measurement.error = compareImages(techniqueValues_, referenceValues_);
  inspect(inspected_, frame_, measurement);
  return measurement;
}

FloatImage Comparison::litBy(GLuint effect) {
  renderer_.drawLighting(effect);
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
