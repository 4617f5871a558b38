#include "host/renderer/shadow/shadow_pass.h"

#include <glm/gtc/matrix_transform.hpp>

#include "host/renderer/bindings.h"
#include "host/renderer/render_state.h"

namespace host {
namespace {

// The filter's reach is answered by the shift along the normal (shaders/host/sun_shadow.glsl); these cover
// the rounding of depths: one texel's slope, and a few of the format's steps.
constexpr float kSlopeScaledOffset = 1.0f;
constexpr float kConstantOffset = 4.0f;

/// Camera-relative world to texture coordinates and window depth of the map.
glm::mat4 mapFromWorld(const ShadowFit& fit, glm::vec3 origin) {
  const glm::mat4 clipToUv =
      glm::translate(glm::mat4(1.0f), glm::vec3(0.5f)) * glm::scale(glm::mat4(1.0f), glm::vec3(0.5f));
  return clipToUv * fit.clipMatrix(origin);
}

mres::gl::SamplerName makeComparingSampler() {
  mres::gl::SamplerName sampler = mres::gl::makeSampler(mres::gl::Filter::linear);
  glSamplerParameteri(sampler.id(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glSamplerParameteri(sampler.id(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  return sampler;
}

}  // namespace

ShadowPass::ShadowPass(const mres::gl::ShaderLibrary& library, const std::optional<Light>& sun, int mapSize)
    : sun_(sun),
      program_(library, {"host/geometry.vert", "host/shadow.frag", ""}),
      target_(glm::ivec2(sun ? mapSize : 1), {}, GL_DEPTH_COMPONENT24, "host.shadow"),
      comparing_(makeComparingSampler()) {
  glUseProgram(program_.id());
  MaterialStore::connect(program_);
  program_.setBlockBinding("ViewParams", bindings::kView);
}

void ShadowPass::draw(const GpuScene& scene, const Camera& camera, const CameraView& view, float aspect,
                      mres::gl::Profiler& profiler) {
  std::optional<ShadowFit> fit;
  if (sun_) {
    fit = fitShadow(camera, view, aspect, scene.instances().bounds(), -sun_->direction, target_.size().x);
  }
  if (fit && fit != drawn_) {
    const mres::gl::Scope scope(profiler, "host.shadow");
    drawn_ = fit;
    drawMap(scene, view.origin);
  }
  isSeen_ = fit.has_value();
  uploadSun(fit, view.origin);
}

SunShadow ShadowPass::shadow(const CameraView& view) const {
  if (!isSeen_) return {};
  return {.map = map().id(),
          .size = map().size(),
          .shadowFromView = mapFromWorld(*drawn_, view.origin) * glm::transpose(view.rotation),
          .directionToSun = -glm::normalize(glm::mat3(view.rotation) * sun_->direction)};
}

void ShadowPass::drawMap(const GpuScene& scene, glm::vec3 origin) {
  mres::params::ViewParams view{};
  view.worldToClip = drawn_->clipMatrix(origin);
  view_.upload(view);
  view_.bind(bindings::kView);
  target_.bind();
  apply({.depth = RenderState::Depth::testAndWrite,
         .slopeScaledOffset = kSlopeScaledOffset,
         .constantOffset = kConstantOffset});
  glClearDepth(1.0);
  glClear(GL_DEPTH_BUFFER_BIT);
  glUseProgram(program_.id());
  // Both sides cast shadows: rooms are often modelled by walls without an outside.
  scene.draw(scene.instances().opaque(Frustum(view.worldToClip), origin), GpuScene::Sides::both);
}

void ShadowPass::uploadSun(const std::optional<ShadowFit>& fit, glm::vec3 origin) {
  mres::params::SunParams params{};
  if (fit) {  // else nothing is seen that could be lit
    params.worldToShadow = mapFromWorld(*fit, origin);
    params.directionToSun = glm::vec4(-glm::normalize(sun_->direction), 0.0f);
    params.sunIlluminance = glm::vec4(sun_->color * sun_->intensity, 0.0f);
    params.shadowTexel = 1.0f / static_cast<float>(target_.size().x);
    params.shadowTexelMetres = static_cast<float>(fit->extent) * params.shadowTexel;
  }
  params_.upload(params);
}

void ShadowPass::connect(const mres::gl::Program& program) {
  program.setBlockBinding("SunParams", bindings::kSun);
  program.setTextureUnit("shadowMap", bindings::kShadowMap);
}

void ShadowPass::bind() const {
  params_.bind(bindings::kSun);
  mres::gl::bindTexture(bindings::kShadowMap, map().id(), comparing_);
}

}  // namespace host
