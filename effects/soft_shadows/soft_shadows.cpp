#include "effects/soft_shadows/soft_shadows.h"

#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <stdexcept>

#include "effects/common/embedded_shaders.h"
#include "effects/soft_shadows/disk_samples.h"
#include "mres/gl/bound_texture.h"
#include "mres/gl/uniform_buffer.h"
#include "mres/validate.h"
#include "shaders/effects/soft_shadows_params.h"

namespace mres {

namespace {

constexpr GLuint kParamsBinding = kEffectBlockBinding;
constexpr GLuint kSamplesBinding = kEffectBlockBinding + 1;

void requireUsable(const ShadowInputs& inputs) {
  if (inputs.shadowMap == 0) return;
  if (!isTextureSize(inputs.mapSize)) {
    throw std::invalid_argument("ShadowInputs::mapSize must be 1 to 16384 texels in each direction.");
  }
  if (!isFinite(inputs.shadowFromView)) {
    throw std::invalid_argument("ShadowInputs::shadowFromView must be a finite matrix.");
  }
}

bool isParallel(const glm::vec4& rowW) {
  return glm::vec3(rowW) == glm::vec3(0.0f);
}

/// Along a spot light's axis window depth is a + b / w: (a, b). b is 0 for parallel light.
glm::vec2 mapDistance(const glm::vec4& rowDepth, const glm::vec4& rowW) {
  if (isParallel(rowW)) return glm::vec2(0.0f);
  const glm::vec3 axis(rowW);
  const float a = glm::dot(glm::vec3(rowDepth), axis) / glm::dot(axis, axis);
  return {a, rowDepth.w - a * rowW.w};
}

void fillSingly(const std::vector<glm::vec2>& points, glm::vec4* slots) {
  for (const glm::vec2 point : points) *slots++ = glm::vec4(point, 0.0f, 0.0f);
}

/// Two a slot.
void fillInPairs(const std::vector<glm::vec2>& points, glm::vec4* slots) {
  for (std::size_t i = 0; i < points.size(); i += 2) {
    const glm::vec2 second = i + 1 < points.size() ? points[i + 1] : glm::vec2(0.0f);
    *slots++ = glm::vec4(points[i], second);
  }
}

params::SoftShadowsSamples makeSamples(const SoftShadowSettings& settings) {
  params::SoftShadowsSamples samples{};
  fillInPairs(diskSamples(settings.samples, settings.seed), samples.samples);
  fillSingly(diskSamplesToTheRim(SOFT_SHADOWS_BLOCKER_SAMPLES, settings.seed), samples.blockerSamples);
  fillSingly(diskSamplesToTheRim(SOFT_SHADOWS_PREVIEW_SAMPLES, settings.seed), samples.previewSamples);
  return samples;
}

params::SoftShadowsParams makeParams(const SoftShadowSettings& settings, const ShadowInputs& inputs) {
  params::SoftShadowsParams params{};
  params.shadowU = glm::row(inputs.shadowFromView, 0);
  params.shadowV = glm::row(inputs.shadowFromView, 1);
  params.shadowDepth = glm::row(inputs.shadowFromView, 2);
  params.shadowW = glm::row(inputs.shadowFromView, 3);
  params.light = inputs.light;
  params.shadowMapSize = inputs.shadowMap == 0 ? glm::ivec2(0) : inputs.mapSize;
  params.mapDistance = mapDistance(params.shadowDepth, params.shadowW);
  params.filterRadius = settings.filterRadius;
  params.penumbraScale = settings.contactHardening ? lightExtent(settings, isParallel(params.shadowW)) : 0.0f;
  params.bias = settings.bias;
  params.sampleCount = settings.samples;
  return params;
}

}  // namespace

static_assert(kMaxSoftShadowSamples == SOFT_SHADOWS_MAX_SAMPLES);

float lightExtent(const SoftShadowSettings& settings, bool parallel) {
  return parallel ? std::tan(0.5f * glm::radians(settings.lightAngle)) : settings.lightRadius;
}

struct SoftShadows::Resources {
  gl::UniformBuffer<params::SoftShadowsParams> params;
  gl::UniformBuffer<params::SoftShadowsSamples> samples;
  gl::SamplerName sampler = gl::makeSampler(gl::Filter::nearest);
};

SoftShadows::SoftShadows(const SoftShadowSettings& settings) : resources_(std::make_unique<Resources>()) {
  setSettings(settings);
}

SoftShadows::~SoftShadows() = default;

void SoftShadows::setSettings(const SoftShadowSettings& settings) {
  validate("SoftShadowSettings", settings);
  validate(settings.levels);
  samplesUploaded_ =
      samplesUploaded_ && settings.samples == settings_.samples && settings.seed == settings_.seed;
  settings_ = settings;
}

void SoftShadows::setInputs(const ShadowInputs& inputs) {
  requireUsable(inputs);
  inputs_ = inputs;
}

const EffectDescription& SoftShadows::description() const {
  static const EffectDescription kDescription{.name = "ssm",
                                              .shader = "effects/soft_shadows.glsl",
                                              .shaders = effects::embeddedShaders(),
                                              .channels = 1,
                                              .background = glm::vec4(1.0f),
                                              .filtered = true,
                                              .readsPyramid = false,
                                              .hasPreview = true};
  return kDescription;
}

void SoftShadows::setUp(const gl::Program& program) {
  program.setBlockBinding("SoftShadowsParams", kParamsBinding);
  program.setBlockBinding("SoftShadowsSamples", kSamplesBinding);
  program.setTextureUnit("shadowMap", kEffectTextureUnit);
}

std::optional<Constant> SoftShadows::constant() const {
  if (inputs_.shadowMap != 0) return std::nullopt;
  return Constant{glm::vec4(1.0f), "there is no shadow map"};
}

void SoftShadows::bind(const Frame& /*frame*/) {
  if (!samplesUploaded_) resources_->samples.upload(makeSamples(settings_));
  samplesUploaded_ = true;
  resources_->samples.bind(kSamplesBinding);
  resources_->params.upload(makeParams(settings_, inputs_));
  resources_->params.bind(kParamsBinding);
  if (inputs_.shadowMap == 0) return gl::bindTexture(kEffectTextureUnit, 0, resources_->sampler);
  const gl::BoundTexture map("ShadowInputs::shadowMap", kEffectTextureUnit, inputs_.shadowMap,
                             resources_->sampler);
  map.requireSize(inputs_.mapSize, "ShadowInputs::mapSize is");
  map.requireDepth();
}

}  // namespace mres
