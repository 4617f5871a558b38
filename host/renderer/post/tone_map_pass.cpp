#include "host/renderer/post/tone_map_pass.h"

#include "host/renderer/bindings.h"
#include "host/renderer/render_state.h"

namespace host {

ToneMapPass::ToneMapPass(const mres::gl::ShaderLibrary& library)
    : program_(library, {"common/full_screen.vert", "host/tone_map.frag", ""}),
      nearest_(mres::gl::makeSampler(mres::gl::Filter::nearest)) {
  glUseProgram(program_.id());
  program_.setBlockBinding("ToneMapParams", bindings::kToneMap);
  program_.setTextureUnit("radianceTexture", bindings::kFirstScreenTexture);
}

void ToneMapPass::draw(const mres::gl::Texture2D& radiance, float exposure, mres::gl::Profiler& profiler) {
  const mres::gl::Scope scope(profiler, "host.toneMap");
  if (!target_ || target_.size() != radiance.size()) {
    target_ = {};  // frees the old one first
    target_ = mres::gl::RenderTarget(radiance.size(), {GL_RGBA8}, 0, "host.toneMap");
  }
  target_.bind();
  apply(RenderState{});
  glUseProgram(program_.id());
  params_.upload({exposure, 0.0f, 0.0f, 0.0f});
  params_.bind(bindings::kToneMap);
  mres::gl::bindTexture(bindings::kFirstScreenTexture, radiance.id(), nearest_);
  triangle_.draw();
}

}  // namespace host
