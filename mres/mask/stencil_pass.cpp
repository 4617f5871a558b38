#include "mres/mask/stencil_pass.h"

namespace mres {

StencilPass::StencilPass(const gl::ShaderLibrary& library)
    : byMask_(makePassProgram(library, "mres/stencil.frag", "#define PROGRESSIVE 0\n")),
      byMaskAndRefinement_(makePassProgram(library, "mres/stencil.frag", "#define PROGRESSIVE 1\n")) {}

void StencilPass::draw(PassContext& context, const gl::RenderTarget& target, const ZoneInputs& zone) {
  const gl::Scope scope(context.profiler, "mres.stencil");
  constexpr GLint kOutside = 0;
  target.bind();
  glClearBufferiv(GL_STENCIL, 0, &kOutside);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, kZone, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  glColorMaski(0, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl::bindTexture(kMaskUnit, zone.mask->id(), context.linear);
  if (zone.refine != nullptr) gl::bindTexture(kRefineUnit, zone.refine->id(), context.linear);
  glUseProgram(zone.refine != nullptr ? byMaskAndRefinement_.id() : byMask_.id());
  context.triangle.draw();
  glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_STENCIL_TEST);
}

void testStencil(GLenum function) {
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(function, kZone, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

}  // namespace mres
