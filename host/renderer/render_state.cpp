#include "host/renderer/render_state.h"

#include <array>

namespace host {
namespace {

void enable(GLenum capability, bool on) {
  on ? glEnable(capability) : glDisable(capability);
}

}  // namespace

void apply(const RenderState& state) {
  static constexpr std::array<GLenum, 10> kUnused = {
      GL_SCISSOR_TEST,    GL_STENCIL_TEST, GL_RASTERIZER_DISCARD,       GL_COLOR_LOGIC_OP,
      GL_DITHER,          GL_DEPTH_CLAMP,  GL_SAMPLE_ALPHA_TO_COVERAGE, GL_PRIMITIVE_RESTART,
      GL_SAMPLE_COVERAGE, GL_SAMPLE_MASK};
  for (const GLenum capability : kUnused) glDisable(capability);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);

  enable(GL_DEPTH_TEST, state.depth != RenderState::Depth::off);
  glDepthMask(state.depth == RenderState::Depth::testAndWrite ? GL_TRUE : GL_FALSE);
  glDepthFunc(GL_LEQUAL);
  glDepthRange(0.0, 1.0);

  enable(GL_BLEND, state.blend == RenderState::Blend::over);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

  enable(GL_FRAMEBUFFER_SRGB, state.encodeSrgb);
  enable(GL_POLYGON_OFFSET_FILL, state.slopeScaledOffset != 0.0f || state.constantOffset != 0.0f);
  glPolygonOffset(state.slopeScaledOffset, state.constantOffset);
  apply(state.cull);
  setMirrored(false);
}

void apply(RenderState::Cull cull) {
  enable(GL_CULL_FACE, cull != RenderState::Cull::none);
  glCullFace(cull == RenderState::Cull::front ? GL_FRONT : GL_BACK);
}

void setMirrored(bool mirrored) {
  glFrontFace(mirrored ? GL_CW : GL_CCW);
}

}  // namespace host
