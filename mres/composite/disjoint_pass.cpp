#include "mres/composite/disjoint_pass.h"

#include "mres/mask/zone_pass.h"

namespace mres {

DisjointPass::DisjointPass(const gl::ShaderLibrary& library)
    : outside_(
          makePassProgram(library, "mres/outside_zone.frag", "#define REFINABLE 0\n#define DISJOINT 1\n")),
      covered_(makePassProgram(library, "mres/covered.frag")) {}

void DisjointPass::startCoarsest(const LevelTargets& level) {
  level.composed().bind();
  startZone();
  glDisable(GL_STENCIL_TEST);
}

void DisjointPass::drawOutsideZone(PassContext& context, const LevelTargets& level, const gl::Texture2D& zone,
                                   const gl::Texture2D& coarser) {
  const gl::Scope scope(context.profiler, "mres.upsample");
  gl::bindTexture(kZoneUnit, zone.id(), context.nearest);
  gl::bindTexture(kCoarserUnit, coarser.id(), context.nearest);
  glUseProgram(outside_.id());
  level.composed().bind();
  startZone();
  context.triangle.draw();
  glDisable(GL_STENCIL_TEST);
}

void DisjointPass::takeFiner(PassContext& context, const LevelTargets& level, const gl::Texture2D& finerZone,
                             int finerLevel) {
  const gl::Scope scope(context.profiler, "mres.stencil");
  gl::bindTexture(kZoneUnit, finerZone.id(), context.nearest);
  glUseProgram(covered_.id());
  glUniform1i(covered_.uniformLocation("finerStride"), 1 << finerLevel);
  level.composed().bind();
  drawOutOfZone();
  glColorMaski(0, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  context.triangle.draw();
  glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_STENCIL_TEST);
}

}  // namespace mres
