#include "mres/mask/zone_pass.h"

namespace mres {

ZonePass::ZonePass(const gl::ShaderLibrary& library)
    : byMask_(makePassProgram(library, "mres/zone.frag", "#define PROGRESSIVE 0\n")),
      byMaskAndRefinement_(makePassProgram(library, "mres/zone.frag", "#define PROGRESSIVE 1\n")) {}

void ZonePass::draw(PassContext& context, const PlannedLevel& level, const ZoneInputs& inputs) {
  const gl::Scope scope(context.profiler, "mres.stencil");
  gl::RenderTarget& target = zones_.at(slot(level.index));
  const glm::ivec2 size = (level.size + ZONE_BLOCK - 1) / ZONE_BLOCK;
  if (target.size() != size) target = gl::RenderTarget(size, {GL_R8}, 0, "mres.zone");
  gl::bindTexture(kMaskUnit, inputs.mask->id(), context.linear);
  if (inputs.refine != nullptr) gl::bindTexture(kZoneUnit, inputs.refine->id(), context.linear);
  glUseProgram(inputs.refine != nullptr ? byMaskAndRefinement_.id() : byMask_.id());
  target.bind();
  context.triangle.draw();
}

void ZonePass::fill(float value) const {
  for (const gl::RenderTarget& zone : zones_) zone.fill(value);
}

std::size_t ZonePass::bytes() const {
  std::size_t sum = 0;
  for (const gl::RenderTarget& zone : zones_) sum += zone.bytes();
  return sum;
}

void startZone() {
  glClearBufferiv(GL_STENCIL, 0, &kZone);
  drawOutOfZone();
}

void drawOutOfZone() {
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, 0, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
}

void drawInZone() {
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, kZone, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

}  // namespace mres
