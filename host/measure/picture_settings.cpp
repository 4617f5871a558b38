#include "host/measure/picture_settings.h"

namespace host {

const std::vector<std::string>& effectNames() {
  static const std::vector<std::string> kNames{"ssao"};
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
  return std::make_unique<mres::Ssao>(settings.ssao);
}

int sampleCount(const PictureSettings& settings) {
  return settings.effect == kNoEffect ? 0 : settings.ssao.samples;
}

}  // namespace host
