#include "host/renderer/lighting/lighting_pass.h"

#include <array>

#include "host/renderer/bindings.h"
#include "host/renderer/render_state.h"

namespace host {
namespace {

/// In the order of their units.
constexpr std::array kScreenTextures = {"depthTexture",           "albedoTexture",     "normalTexture",
                                        "geometricNormalTexture", "materialTexture",   "emissiveTexture",
                                        "accessibilityTexture",   "visibilityTexture", "indirectTexture"};

}  // namespace

LightingPass::LightingPass(const mres::gl::ShaderLibrary& library)
    : program_(library, {"common/full_screen.vert", "host/lighting.frag", ""}),
      hasVisibility_(program_.uniformLocation("hasVisibility")),
      hasIndirect_(program_.uniformLocation("hasIndirect")),
      indirectScale_(program_.uniformLocation("indirectScale")),
      nearest_(mres::gl::makeSampler(mres::gl::Filter::nearest)) {
  glUseProgram(program_.id());
  Illumination::connect(program_);
  program_.setBlockBinding("ViewParams", bindings::kView);
  GLint unit = bindings::kFirstScreenTexture;
  for (const char* name : kScreenTextures) program_.setTextureUnit(name, unit++);
}

void LightingPass::draw(const GBufferTextures& gbuffer, const LightingInputs& inputs, glm::ivec2 size,
                        mres::gl::Profiler& profiler) {
  const mres::gl::Scope scope(profiler, "host.lighting");
  if (!target_ || target_.size() != size) {
    target_ = {};  // frees the old one first
    target_ = mres::gl::RenderTarget(size, {GL_RGBA16F}, 0, "host.lighting");
  }
  target_.bind();
  apply(RenderState{});
  glUseProgram(program_.id());
  const ScreenEffects& effects = inputs.effects;
  glUniform1i(hasVisibility_, effects.visibility != 0 ? 1 : 0);
  glUniform1i(hasIndirect_, effects.indirect != 0 ? 1 : 0);
  glUniform1f(indirectScale_, 1.0f / inputs.exposure);
  const std::array textures = {gbuffer.depth,           gbuffer.albedo,     gbuffer.normal,
                               gbuffer.geometricNormal, gbuffer.material,   gbuffer.emissive,
                               effects.accessibility,   effects.visibility, effects.indirect};
  static_assert(std::tuple_size_v<decltype(textures)> == kScreenTextures.size());
  GLuint unit = bindings::kFirstScreenTexture;
  for (const GLuint texture : textures) mres::gl::bindTexture(unit++, texture, nearest_);
  triangle_.draw();
}

}  // namespace host
