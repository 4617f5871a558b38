#include "host/measure/truth_finder.h"

#include <algorithm>
#include <string_view>

#include "host/truth/ray_traced.h"

namespace host {
namespace {

constexpr int kLeastConvergedSamples = 4096;
constexpr int kConvergedOverPicture = 4;     // samples for each that the picture takes
constexpr int kMostRayTracedPixels = 40000;  // of a picture of any size
constexpr int kSeeds = 65536;                // different ones

constexpr double kShareOfConverging = 0.85;  // of the time, about

/// That the effect takes at once.
template <class EffectSettings>
int mostSamples(EffectSettings& settings) {
  double most = 1.0;
  visit(settings, [&most](std::string_view name, auto&, const mres::SettingInfo& info) {
    if (name == "samples") most = info.max;
  });
  return static_cast<int>(most);
}

int dividedUp(int dividend, int divisor) {
  return (dividend + divisor - 1) / divisor;
}

/// No pass has the seed of the pictures that are measured: their points would look better than they are.
ConvergingPasses passesOf(const PictureSettings& settings, const EffectInputs& inputs) {
  const int total = convergedSamples(sampleCount(settings));
  PictureSettings many = settings;
  int passes = 1;
  visitEffect(many, [&](auto& effect) {
    passes = dividedUp(total, mostSamples(effect));
    effect.samples = dividedUp(total, passes);
  });
  const EffectOfPass effectOf = [many, inputs](int pass) {
    PictureSettings one = many;
    visitEffect(one, [pass](auto& effect) { effect.seed = (effect.seed + 1 + pass) % kSeeds; });
    std::unique_ptr<mres::Effect> effect = makeEffect(one);
    setInputs(*effect, inputs);
    return effect;
  };
  return {effectOf, passes, sampleCount(many)};
}

/// The densest grid of an odd stride that is not too many pixels.
PixelGrid rayGridOf(glm::ivec2 size) {
  PixelGrid grid{.pictureSize = size};
  while (grid.size().x * grid.size().y > kMostRayTracedPixels) grid.stride += 2;
  return grid;
}

LightRays lightRays(const mres::SoftShadowSettings& settings, const mres::Frame& frame,
                    const mres::ShadowInputs& shadow) {
  return {.place = glm::inverse(frame.view) * shadow.light,
          .extent = mres::lightExtent(settings, shadow.light.w == 0.0f),
          .mapFromWorld = shadow.shadowFromView * frame.view};
}

bool hasRayTracedTruth(const PictureSettings& settings, const EffectInputs& inputs) {
  if (settings.effect == kSoftShadowEffect) return inputs.shadow.shadowMap != 0;
  return settings.effect == kSsaoEffect && settings.ssao.radius > 0.0f;
}

}  // namespace

int convergedSamples(int samples) {
  return std::max(kLeastConvergedSamples, kConvergedOverPicture * samples);
}

TruthFinder::TruthFinder(const Scene& scene, const PictureSettings& settings)
    : scene_(scene), settings_(settings), convergedReference_(settings.renderer.shaderDirectory) {}

std::vector<Truth> TruthFinder::find(const mres::Frame& frame, const EffectInputs& inputs,
                                     const WorkObserver& observe) {
  std::vector<Truth> truths;
  truths.push_back(converged(frame, inputs, partOf(observe, 0.0, kShareOfConverging)));
  if (hasRayTracedTruth(settings_, inputs))
    truths.push_back(rayTraced(frame, inputs, partOf(observe, kShareOfConverging, 1.0)));
  return truths;
}

Truth TruthFinder::converged(const mres::Frame& frame, const EffectInputs& inputs,
                             const WorkObserver& observe) {
  return convergedReference_.render(passesOf(settings_, inputs), frame, observe);
}

Truth TruthFinder::rayTraced(const mres::Frame& frame, const EffectInputs& inputs,
                             const WorkObserver& observe) {
  if (!rayScene_) rayScene_.emplace(scene_);
  const GridSurfaces surfaces = readSurfaces(rayGridOf(frame.size), frame);
  if (settings_.effect == kSoftShadowEffect)
    return traceVisibility(*rayScene_, surfaces, lightRays(settings_.softShadows, frame, inputs.shadow),
                           observe);
  return traceAccessibility(*rayScene_, surfaces, {settings_.ssao.radius, settings_.ssao.intensity}, observe);
}

}  // namespace host
