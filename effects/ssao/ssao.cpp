#include "effects/ssao/ssao.h"

#include <algorithm>
#include <iterator>

#include "effects/common/embedded_shaders.h"
#include "effects/common/sample_points.h"
#include "mres/gl/uniform_buffer.h"
#include "mres/validate.h"
#include "shaders/effects/ssao_params.h"

namespace mres {
namespace {

params::SsaoParams makeParams(const SsaoSettings& settings) {
  params::SsaoParams params{};
  params.radius = settings.radius;
  params.bias = settings.bias;
  params.intensity = settings.intensity;
  params.sampleCount = settings.samples;
  std::ranges::copy(hemispherePointsForShader(settings.samples, settings.seed), std::begin(params.samples));
  return params;
}

}  // namespace

static_assert(kMaxSsaoSamples == SSAO_MAX_SAMPLES);

struct Ssao::Block {
  gl::UniformBuffer<params::SsaoParams> params;
};

Ssao::Ssao(const SsaoSettings& settings) : block_(std::make_unique<Block>()) {
  setSettings(settings);
}

Ssao::~Ssao() = default;

void Ssao::setSettings(const SsaoSettings& settings) {
  validate("SsaoSettings", settings);
  validate(settings.levels);
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

std::optional<Constant> Ssao::constant() const {
  if (settings_.intensity > 0.0f) return std::nullopt;
  return Constant{glm::vec4(1.0f), "an intensity of 0 shows nothing"};
}

void Ssao::bind(const Frame& /*frame*/) {
  if (!uploaded_) block_->params.upload(makeParams(settings_));
  uploaded_ = true;
  block_->params.bind(kEffectBlockBinding);
}

}  // namespace mres
