#include "mres/mask/stencil_pass.h"

namespace mres {

StencilPass::StencilPass(const gl::ShaderLibrary& library)
    : program_(makePassProgram(library, "mres/stencil.frag")) {}

void StencilPass::draw(PassContext& context, const gl::RenderTarget& target, const gl::Texture2D& mask) {
  const gl::Scope scope(context.profiler, "mres.stencil");
  constexpr GLint kOutside = 0;
  target.bind();
  glClearBufferiv(GL_STENCIL, 0, &kOutside);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, kZone, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl::bindTexture(kMaskUnit, mask.id(), context.linear);
  glUseProgram(program_.id());
  context.triangle.draw();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_STENCIL_TEST);
}

void testStencil(GLenum function) {
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(function, kZone, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

}  // namespace mres
