#include "host/renderer/shadow/shadow_pass.h"

#include <glm/gtc/matrix_transform.hpp>

#include "host/renderer/bindings.h"
#include "host/renderer/render_state.h"
#include "host/renderer/shadow/spot_view.h"

namespace host {
namespace {

// The filter's reach is answered by the shift along the normal (shaders/host/shadow_lookup.glsl); these cover
// the rounding of depths: one texel's slope, and a few of the format's steps.
constexpr float kSlopeScaledOffset = 1.0f;
constexpr float kConstantOffset = 4.0f;

/// Camera-relative world to texture coordinates and window depth of the map.
glm::mat4 mapFromWorld(const ShadowView& view, glm::vec3 origin) {
  const glm::mat4 clipToUv =
      glm::translate(glm::mat4(1.0f), glm::vec3(0.5f)) * glm::scale(glm::mat4(1.0f), glm::vec3(0.5f));
  return clipToUv * view.clipMatrix(origin);
}

mres::gl::SamplerName makeComparingSampler() {
  mres::gl::SamplerName sampler = mres::gl::makeSampler(mres::gl::Filter::linear);
  glSamplerParameteri(sampler.id(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glSamplerParameteri(sampler.id(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  return sampler;
}

}  // namespace

ShadowPass::ShadowPass(const mres::gl::ShaderLibrary& library, const std::optional<Light>& caster,
                       ShadowMapNeeds needs)
    : caster_(caster),
      needs_(needs),
      program_(library, {"host/geometry.vert", "host/shadow.frag", ""}),
      target_(glm::ivec2(caster ? needs.size : 1), {}, GL_DEPTH_COMPONENT24, "host.shadow"),
      comparing_(makeComparingSampler()) {
  glUseProgram(program_.id());
  MaterialStore::connect(program_);
  program_.setBlockBinding("ViewParams", bindings::kView);
}

std::optional<ShadowView> ShadowPass::viewOf(const Bounds& scene, const Camera& camera,
                                             const CameraView& view, float aspect) const {
  if (!caster_) return std::nullopt;
  if (caster_->type == LightType::spot) return spotView(*caster_, scene, needs_.size);
  const auto fit = fitShadow(camera, view, aspect, scene, -caster_->direction, needs_);
  return fit ? std::optional(fit->view(needs_.size)) : std::nullopt;
}

void ShadowPass::draw(const GpuScene& scene, const Camera& camera, const CameraView& view, float aspect,
                      mres::gl::Profiler& profiler) {
  const std::optional<ShadowView> wanted = viewOf(scene.instances().bounds(), camera, view, aspect);
  if (wanted && wanted != drawn_) {
    const mres::gl::Scope scope(profiler, "host.shadow");
    drawn_ = wanted;
    drawMap(scene, view.origin);
  }
  isSeen_ = wanted.has_value();
  upload(wanted, view.origin);
}

ShadowMap ShadowPass::shadow(const CameraView& view) const {
  if (!isSeen_) return {};
  const glm::mat3 viewFromWorld(view.rotation);
  return {.map = map().id(),
          .size = map().size(),
          .shadowFromView = mapFromWorld(*drawn_, view.origin) * glm::transpose(view.rotation),
          .light = caster_->type == LightType::spot
                       ? glm::vec4(viewFromWorld * view.relative(caster_->position), 1.0f)
                       : glm::vec4(-glm::normalize(viewFromWorld * caster_->direction), 0.0f)};
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

void ShadowPass::upload(const std::optional<ShadowView>& view, glm::vec3 origin) {
  mres::params::ShadowParams params{};
  if (view) {  // else nothing is seen that could be lit
    params.worldToShadow = mapFromWorld(*view, origin);
    params.shadowTexel = 1.0f / static_cast<float>(needs_.size);
    params.shadowTexelMetres = static_cast<float>(view->texelMetres);
  }
  params_.upload(params);
}

void ShadowPass::connect(const mres::gl::Program& program) {
  program.setBlockBinding("ShadowParams", bindings::kShadow);
  program.setTextureUnit("shadowMap", bindings::kShadowMap);
}

void ShadowPass::bind() const {
  params_.bind(bindings::kShadow);
  mres::gl::bindTexture(bindings::kShadowMap, map().id(), comparing_);
}

}  // namespace host
