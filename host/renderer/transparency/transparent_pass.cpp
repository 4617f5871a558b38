#include "host/renderer/transparency/transparent_pass.h"

#include "host/renderer/bindings.h"
#include "host/renderer/render_state.h"

namespace host {

TransparentPass::TransparentPass(const mres::gl::ShaderLibrary& library)
    : program_(library, {"host/geometry.vert", "host/transparent.frag", ""}),
      framebuffer_(mres::gl::FramebufferName::create()) {
  glUseProgram(program_.id());
  MaterialStore::connect(program_);
  Illumination::connect(program_);
  program_.setBlockBinding("ViewParams", bindings::kView);
}

void TransparentPass::draw(const GpuScene& scene, const CameraView& view, const mres::gl::Texture2D& radiance,
                           GLuint depth, mres::gl::Profiler& profiler) {
  const DrawList list = scene.instances().blended(view);
  if (list.empty()) return;
  const mres::gl::Scope scope(profiler, "host.transparency");
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, radiance.id(), 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
  glViewport(0, 0, radiance.size().x, radiance.size().y);
  apply({.depth = RenderState::Depth::test, .blend = RenderState::Blend::over});
  glUseProgram(program_.id());
  scene.draw(list, GpuScene::Sides::backThenFront);
}

}  // namespace host
