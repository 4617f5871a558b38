#include "host/renderer/gbuffer/gbuffer_pass.h"

#include <array>

#include "host/renderer/bindings.h"
#include "host/renderer/render_state.h"

namespace host {

GBufferPass::GBufferPass(const mres::gl::ShaderLibrary& library)
    : program_(library, {"host/geometry.vert", "host/gbuffer.frag", ""}) {
  glUseProgram(program_.id());
  MaterialStore::connect(program_);
  program_.setBlockBinding("ViewParams", bindings::kView);
}

void GBufferPass::resize(glm::ivec2 size) {
  if (target_ && target_.size() == size) return;
  target_ = {};  // frees the old one first
  target_ =
      mres::gl::RenderTarget(size, {GL_SRGB8_ALPHA8, GL_RGB10_A2, GL_RGB10_A2, GL_RGBA8, GL_R11F_G11F_B10F},
                             GL_DEPTH_COMPONENT32F, "host.gbuffer");
  textures_ = {.depth = target_.depthStencil().id(),
               .albedo = target_.color(0).id(),
               .normal = target_.color(1).id(),
               .geometricNormal = target_.color(2).id(),
               .material = target_.color(3).id(),
               .emissive = target_.color(4).id()};
}

void GBufferPass::clear() const {
  static constexpr std::array<float, 4> kNothing = {0.0f, 0.0f, 0.0f, 0.0f};
  static constexpr std::array<float, 4> kNoDirection = {0.5f, 0.5f, 0.5f, 0.0f};
  const std::array colors = {&kNothing, &kNoDirection, &kNoDirection, &kNothing, &kNothing};
  for (std::size_t i = 0; i < colors.size(); ++i) {
    glClearBufferfv(GL_COLOR, static_cast<GLint>(i), colors[i]->data());
  }
  static constexpr float kFar = 1.0f;
  glClearBufferfv(GL_DEPTH, 0, &kFar);
}

void GBufferPass::draw(const GpuScene& scene, const CameraView& view, glm::ivec2 size,
                       mres::gl::Profiler& profiler) {
  const mres::gl::Scope scope(profiler, "host.gbuffer");
  resize(size);
  target_.bind();
  apply({.depth = RenderState::Depth::testAndWrite, .cull = RenderState::Cull::back, .encodeSrgb = true});
  clear();
  glUseProgram(program_.id());
  scene.draw(scene.instances().opaque(view.frustum(), view.origin), GpuScene::Sides::asMaterial);
}

}  // namespace host
