#include "effects/ssao/ssao.h"

#include <cmath>
#include <span>
#include <stdexcept>
#include <string>

#include "effects/ssao/sample_points.h"

namespace mres {

namespace effects {
std::span<const gl::ShaderFile> embeddedShaders();
}

namespace {

params::SsaoParams makeParams(const SsaoSettings& settings) {
  params::SsaoParams params{};
  params.radius = settings.radius;
  params.bias = settings.bias;
  params.intensity = settings.intensity;
  params.sampleCount = settings.samples;
  int index = 0;
  for (const glm::vec3 point : hemispherePoints(settings.samples, settings.seed)) {
    params.samples[index++] = glm::vec4(point, std::log2(glm::length(point)));
  }
  return params;
}

void validate(SsaoSettings settings) {
  visit(settings, [](const char* name, auto value, const SettingInfo& info) {
    if (!(value >= info.min && value <= info.max)) {
      throw std::invalid_argument(std::string("SsaoSettings::") + name + " must be " +
                                  std::to_string(info.min) + " to " + std::to_string(info.max) + ".");
    }
  });
}

}  // namespace

Ssao::Ssao(const SsaoSettings& settings) {
  setSettings(settings);
}

void Ssao::setSettings(const SsaoSettings& settings) {
  validate(settings);
  settings_ = settings;
  uploaded_ = false;
}

const EffectDescription& Ssao::description() const {
  static const EffectDescription kDescription{.name = "ssao",
                                              .shader = "effects/ssao.glsl",
                                              .shaders = effects::embeddedShaders(),
                                              .channels = 1,
                                              .background = glm::vec4(1.0f),
                                              .filtered = true,
                                              .readsPyramid = true};
  return kDescription;
}

void Ssao::setUp(const gl::Program& program) {
  program.setBlockBinding("SsaoParams", kEffectBlockBinding);
}

void Ssao::bind() {
  if (!uploaded_) params_.upload(makeParams(settings_));
  uploaded_ = true;
  params_.bind(kEffectBlockBinding);
}

}  // namespace mres
