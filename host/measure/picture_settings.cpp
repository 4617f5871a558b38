#include "host/measure/picture_settings.h"

namespace host {

const std::vector<std::string>& effectNames() {
  static const std::vector<std::string> kNames{kSsaoEffect, kSoftShadowEffect, kSsgiEffect};
  return kNames;
}

std::unique_ptr<mres::Effect> makeEffect(const PictureSettings& settings) {
  if (settings.effect == kNoEffect) return nullptr;
  if (settings.effect == kSoftShadowEffect) return std::make_unique<mres::SoftShadows>(settings.softShadows);
  if (settings.effect == kSsgiEffect) return std::make_unique<mres::Ssgi>(settings.ssgi);
  return std::make_unique<mres::Ssao>(settings.ssao);
}

RendererSettings rendererSettings(const PictureSettings& settings) {
  RendererSettings renderer = settings.renderer;
  if (settings.effect == kSoftShadowEffect) renderer.shadowReach = settings.softShadows.filterRadius;
  return renderer;
}

namespace {

mres::ShadowInputs shadowInputs(const Renderer& renderer) {
  const ShadowMap shadow = renderer.shadowMap();
  return {.shadowMap = shadow.map,
          .mapSize = shadow.size,
          .shadowFromView = shadow.shadowFromView,
          .light = shadow.light};
}

/// Light bounces off opaque surfaces as they are lit without the effect.
mres::SsgiInputs ssgiInputs(Renderer& renderer) {
  const AmbientLight ambient = renderer.ambient();
  return {.radiance = renderer.drawOpaqueLighting({}),
          .radianceScale = renderer.exposure(),
          .environmentAbove = ambient.above * renderer.exposure(),
          .environmentBelow = ambient.below * renderer.exposure(),
          .up = glm::normalize(glm::mat3(renderer.view())[1])};
}

}  // namespace

EffectInputs drawInputs(Renderer& renderer, const PictureSettings& settings) {
  EffectInputs inputs;
  if (settings.effect == kSoftShadowEffect) inputs.shadow = shadowInputs(renderer);
  if (settings.effect == kSsgiEffect) inputs.ssgi = ssgiInputs(renderer);
  return inputs;
}

void setInputs(mres::Effect& effect, const EffectInputs& inputs) {
  if (auto* softShadows = dynamic_cast<mres::SoftShadows*>(&effect)) softShadows->setInputs(inputs.shadow);
  if (auto* ssgi = dynamic_cast<mres::Ssgi*>(&effect)) ssgi->setInputs(inputs.ssgi);
}

ScreenEffects screenEffects(const PictureSettings& settings, GLuint values) {
  if (settings.effect == kSoftShadowEffect) return {.visibility = values};
  if (settings.effect == kSsgiEffect) return {.indirect = values};
  return {.accessibility = values};
}

int sampleCount(const PictureSettings& settings) {
  if (settings.effect == kNoEffect) return 0;
  PictureSettings copy = settings;
  int samples = 0;
  visitEffect(copy, [&samples](const auto& effect) { samples = effect.samples; });
  return samples;
}

}  // namespace host
