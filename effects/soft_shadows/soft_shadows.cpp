#include "effects/soft_shadows/soft_shadows.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <span>
#include <stdexcept>

#include "effects/soft_shadows/disk_samples.h"
#include "mres/gl/bound_texture.h"
#include "mres/gl/uniform_buffer.h"
#include "mres/validate.h"
#include "shaders/effects/soft_shadows_params.h"

namespace mres {

namespace effects {
std::span<const gl::ShaderFile> embeddedShaders();
}

namespace {

constexpr int kMaxMapSize = 16384;

bool isFinite(const glm::mat4& matrix) {
  const float* values = &matrix[0][0];
  return std::all_of(values, values + 16, [](float value) { return std::isfinite(value); });
}

void requireUsable(const ShadowInputs& inputs) {
  if (inputs.shadowMap == 0) return;
  const glm::ivec2 size = inputs.mapSize;
  if (size.x < 1 || size.y < 1 || size.x > kMaxMapSize || size.y > kMaxMapSize) {
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

float penumbraScale(const SoftShadowSettings& settings, bool parallel) {
  if (!settings.contactHardening) return 0.0f;
  return parallel ? std::tan(0.5f * glm::radians(settings.lightAngle)) : settings.lightRadius;
}

void setSamples(const SoftShadowSettings& settings, params::SoftShadowsParams& params) {
  const std::vector<glm::vec2> disk = diskSamples(settings.samples, settings.seed);
  for (std::size_t i = 0; i < disk.size(); ++i) {
    glm::vec4& pair = params.samples[i / 2];
    (i % 2 == 0 ? pair.x : pair.z) = disk[i].x;
    (i % 2 == 0 ? pair.y : pair.w) = disk[i].y;
  }
  int index = 0;
  for (const glm::vec2 sample : diskSamplesToTheRim(SOFT_SHADOWS_BLOCKER_SAMPLES)) {
    params.blockerSamples[index++] = glm::vec4(sample, 0.0f, 0.0f);
  }
  index = 0;
  for (const glm::vec2 sample : diskSamplesToTheRim(SOFT_SHADOWS_PREVIEW_SAMPLES)) {
    params.previewSamples[index++] = glm::vec4(sample, 0.0f, 0.0f);
  }
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
  params.penumbraScale = penumbraScale(settings, isParallel(params.shadowW));
  params.bias = settings.bias;
  params.sampleCount = settings.samples;
  setSamples(settings, params);
  return params;
}

}  // namespace

static_assert(kMaxSoftShadowSamples == SOFT_SHADOWS_MAX_SAMPLES);

struct SoftShadows::Resources {
  gl::UniformBuffer<params::SoftShadowsParams> params;
  gl::SamplerName sampler = gl::makeSampler(gl::Filter::nearest);
};

SoftShadows::SoftShadows(const SoftShadowSettings& settings) : resources_(std::make_unique<Resources>()) {
  setSettings(settings);
}

SoftShadows::~SoftShadows() = default;

void SoftShadows::setSettings(const SoftShadowSettings& settings) {
  validate("SoftShadowSettings", settings);
  validate(settings.levels);
  settings_ = settings;
  uploaded_ = false;
}

void SoftShadows::setInputs(const ShadowInputs& inputs) {
  requireUsable(inputs);
  inputs_ = inputs;
  uploaded_ = false;
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
  program.setBlockBinding("SoftShadowsParams", kEffectBlockBinding);
  program.setTextureUnit("shadowMap", kEffectTextureUnit);
}

void SoftShadows::bind(const Frame& /*frame*/) {
  if (!uploaded_) resources_->params.upload(makeParams(settings_, inputs_));
  uploaded_ = true;
  resources_->params.bind(kEffectBlockBinding);
  if (inputs_.shadowMap == 0) return gl::bindTexture(kEffectTextureUnit, 0, resources_->sampler);
  const gl::BoundTexture map("ShadowInputs::shadowMap", kEffectTextureUnit, inputs_.shadowMap,
                             resources_->sampler);
  map.requireSize(inputs_.mapSize, "ShadowInputs::mapSize is");
  map.requireDepth();
}

}  // namespace mres
