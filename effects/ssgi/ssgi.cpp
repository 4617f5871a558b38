#include "effects/ssgi/ssgi.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "effects/common/embedded_shaders.h"
#include "effects/common/sample_points.h"
#include "effects/ssgi/sender_pyramid.h"
#include "mres/gl/bound_texture.h"
#include "mres/gl/texture.h"
#include "mres/gl/uniform_buffer.h"
#include "mres/validate.h"
#include "shaders/effects/ssgi_params.h"

namespace mres {
namespace {

constexpr GLuint kParamsBinding = kEffectBlockBinding;
constexpr GLuint kPointsBinding = kEffectBlockBinding + 1;
constexpr GLuint kPointsUnit = kEffectTextureUnit;
constexpr GLuint kSendersUnit = kEffectTextureUnit + 1;

/// The largest half float: results are stored as such.
constexpr float kLargestRadiance = 65504.0f;

params::SsgiParams makeParams(const SsgiSettings& settings, const SsgiInputs& inputs) {
  params::SsgiParams params{};
  params.radius = settings.radius;
  params.bias = settings.bias;
  params.bounce = inputs.radiance == 0 ? 0.0f : settings.intensity;
  params.sampleCount = settings.samples;
  params.up = glm::vec4(inputs.up, 0.0f);
  params.environmentAbove = glm::vec4(inputs.environmentAbove, 0.0f);
  params.environmentBelow = glm::vec4(inputs.environmentBelow, 0.0f);
  params.radianceScale = inputs.radianceScale;
  params.maxRadiance = settings.maxRadiance;
  return params;
}

/// At least one row, so that there is a texture to bind.
gl::Texture2D makePointTexture(std::span<const glm::vec4> points) {
  const std::size_t rows =
      std::max<std::size_t>(1, (points.size() + SSGI_POINTS_PER_ROW - 1) / SSGI_POINTS_PER_ROW);
  std::vector<glm::vec4> texels(points.begin(), points.end());
  texels.resize(rows * SSGI_POINTS_PER_ROW);
  return {GL_RGBA32F, {SSGI_POINTS_PER_ROW, rows}, "mres.ssgi.points", 1, texels.data()};
}

void validateRadiance(const char* name, float value) {
  if (!(value >= 0.0f && value <= kLargestRadiance)) {
    throw std::invalid_argument(std::string("SsgiInputs::") + name + " must be 0 to 65504.");
  }
}

void validate(const SsgiInputs& inputs) {
  validateRadiance("radianceScale", inputs.radianceScale);
  for (int channel = 0; channel < 3; ++channel) {
    validateRadiance("environmentAbove", inputs.environmentAbove[channel]);
    validateRadiance("environmentBelow", inputs.environmentBelow[channel]);
  }
  constexpr float kTolerance = 0.01f;
  if (!(std::abs(glm::length(inputs.up) - 1.0f) <= kTolerance)) {
    throw std::invalid_argument("SsgiInputs::up must have unit length.");
  }
}

}  // namespace

struct Ssgi::Resources {
  void setPoints(int count, int seed);
  void bindSenders(GLuint radiance, glm::ivec2 size, bool areSeen);

  gl::UniformBuffer<params::SsgiParams> params;
  gl::UniformBuffer<params::SsgiPoints> points;  // all of them in a texture take a tenth more time
  gl::Texture2D morePoints;
  std::optional<SenderPyramid> senders;  // made for the first lit picture
  gl::SamplerName nearest = gl::makeSampler(gl::Filter::nearest);
};

void Ssgi::Resources::setPoints(int count, int seed) {
  const std::vector<glm::vec4> all = hemispherePointsForShader(count, seed);
  const std::size_t inBlock = std::min<std::size_t>(all.size(), SSGI_BLOCK_POINTS);
  params::SsgiPoints block{};
  std::copy_n(all.begin(), inBlock, std::begin(block.points));
  points.upload(block);
  morePoints = makePointTexture(std::span(all).subspan(inBlock));
}

void Ssgi::Resources::bindSenders(GLuint radiance, glm::ivec2 size, bool areSeen) {
  // Without a lit picture the shader still reads senders, and drivers warn of none: any complete texture will
  // do.
  if (radiance == 0) return gl::bindTexture(kSendersUnit, morePoints.id(), nearest);
  const gl::BoundTexture picture("SsgiInputs::radiance", kSendersUnit, radiance, nearest);
  picture.requireSize(size, "Frame::size is");
  picture.requireChannels(3);
  if (!areSeen) return gl::bindTexture(kSendersUnit, morePoints.id(), nearest);
  if (!senders) senders.emplace(kSendersUnit, kParamsBinding);
  senders->draw(size);
}

Ssgi::Ssgi(const SsgiSettings& settings) : resources_(std::make_unique<Resources>()) {
  setSettings(settings);
}

Ssgi::~Ssgi() = default;

void Ssgi::setSettings(const SsgiSettings& settings) {
  validate("SsgiSettings", settings);
  validate(settings.levels);
  pointsUploaded_ =
      pointsUploaded_ && settings.samples == settings_.samples && settings.seed == settings_.seed;
  settings_ = settings;
}

void Ssgi::setInputs(const SsgiInputs& inputs) {
  validate(inputs);
  inputs_ = inputs;
}

const EffectDescription& Ssgi::description() const {
  static const EffectDescription kDescription{.name = "ssgi",
                                              .shader = "effects/ssgi.glsl",
                                              .shaders = effects::embeddedShaders(),
                                              .channels = 3,
                                              .filtered = true,
                                              .readsPyramid = true};
  return kDescription;
}

void Ssgi::setUp(const gl::Program& program) {
  program.setBlockBinding("SsgiParams", kParamsBinding);
  program.setBlockBinding("SsgiPoints", kPointsBinding);
  program.setTextureUnit("morePoints", kPointsUnit);
  program.setTextureUnit("senders", kSendersUnit);
}

/// What an upright surface in the open receives.
glm::vec4 Ssgi::background() const {
  return {0.5f * (inputs_.environmentAbove + inputs_.environmentBelow), 0.0f};
}

std::optional<Constant> Ssgi::constant() const {
  const bool bounces = inputs_.radiance != 0 && settings_.intensity > 0.0f && inputs_.radianceScale > 0.0f;
  const bool dark = inputs_.environmentAbove + inputs_.environmentBelow == glm::vec3(0.0f);
  if (bounces || !dark) return std::nullopt;
  return Constant{glm::vec4(0.0f), "nothing sends light"};
}

std::size_t Ssgi::bytes() const {
  return resources_->morePoints.bytes() + (resources_->senders ? resources_->senders->bytes() : 0);
}

void Ssgi::bind(const Frame& frame) {
  if (!pointsUploaded_) resources_->setPoints(settings_.samples, settings_.seed);
  pointsUploaded_ = true;
  resources_->points.bind(kPointsBinding);
  resources_->params.upload(makeParams(settings_, inputs_));
  resources_->params.bind(kParamsBinding);
  gl::bindTexture(kPointsUnit, resources_->morePoints.id(), resources_->nearest);
  resources_->bindSenders(inputs_.radiance, frame.size, settings_.intensity > 0.0f);
}

}  // namespace mres
