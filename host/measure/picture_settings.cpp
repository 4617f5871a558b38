#include "host/measure/picture_settings.h"

namespace host {

const std::vector<std::string>& effectNames() {
  static const std::vector<std::string> kNames{kSsaoEffect, kSoftShadowEffect};
  return kNames;
}

const std::vector<std::string>& techniqueNames() {
  static const std::vector<std::string> kNames{"full", "mres"};
  return kNames;
}

std::string nameOf(mres::Technique technique) {
  return techniqueNames()[technique == mres::Technique::full ? 0 : 1];
}

std::unique_ptr<mres::Effect> makeEffect(const PictureSettings& settings) {
  if (settings.effect == kNoEffect) return nullptr;
  if (settings.effect == kSoftShadowEffect) return std::make_unique<mres::SoftShadows>(settings.softShadows);
  return std::make_unique<mres::Ssao>(settings.ssao);
}

void setInputs(mres::Effect& effect, const Renderer& renderer) {
  if (auto* softShadows = dynamic_cast<mres::SoftShadows*>(&effect)) {
    const SunShadow sun = renderer.sunShadow();
    softShadows->setInputs({.shadowMap = sun.map,
                            .mapSize = sun.size,
                            .shadowFromView = sun.shadowFromView,
                            .light = glm::vec4(sun.directionToSun, 0.0f)});
  }
}

ScreenEffects screenEffects(const PictureSettings& settings, GLuint values) {
  if (settings.effect == kSoftShadowEffect) return {.sunVisibility = values};
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
