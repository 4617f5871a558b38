#include "mres/composite/composite_pass.h"

#include <string>

#include "mres/mask/zone_pass.h"

namespace mres {
namespace {

std::string defines(const EffectDescription& effect, LevelRole role) {
  const auto define = [](const char* name, int value) {
    return std::string("#define ") + name + ' ' + std::to_string(value) + '\n';
  };
  return define("DISJOINT", 0) + define("EFFECT_CHANNELS", effect.channels) +
         define("FILTERED", effect.filtered ? 1 : 0) +
         define("COARSEST", role == LevelRole::coarsest ? 1 : 0) +
         define("MASKED", role == LevelRole::masked ? 1 : 0) +
         define("REFINABLE", role == LevelRole::refinable ? 1 : 0);
}

}  // namespace

CompositePass::CompositePass(const gl::ShaderLibrary& library, const EffectDescription& effect)
    : filtered_(effect.filtered),
      filter_(makePassProgram(library, "mres/filter_horizontal.frag", defines(effect, LevelRole::coarsest))),
      alone_(makePassProgram(library, "mres/composite.frag", defines(effect, LevelRole::coarsest))),
      masked_(makeZonePrograms(library, effect, LevelRole::masked)),
      zoned_(makeZonePrograms(library, effect, LevelRole::zoned)),
      refinable_(makeZonePrograms(library, effect, LevelRole::refinable)) {}

CompositePass::ZonePrograms CompositePass::makeZonePrograms(const gl::ShaderLibrary& library,
                                                            const EffectDescription& effect, LevelRole role) {
  return {.blend = makePassProgram(library, "mres/composite.frag", defines(effect, role)),
          .outside = makePassProgram(library, "mres/outside_zone.frag", defines(effect, role))};
}

const gl::Texture2D& CompositePass::filterAlongX(PassContext& context, const LevelTargets& level) {
  if (!filtered_) return level.raw().color();
  const gl::Scope scope(context.profiler, "mres.filter");
  level.filteredAlongX().bind();
  if (level.role() != LevelRole::coarsest) clearAndDrawInZone();
  gl::bindTexture(kSourceUnit, level.raw().color().id(), context.nearest);
  glUseProgram(filter_.id());
  context.triangle.draw();
  glDisable(GL_STENCIL_TEST);
  return level.filteredAlongX().color();
}

void CompositePass::drawAlone(PassContext& context, const LevelTargets& level) {
  const gl::Texture2D& source = filterAlongX(context, level);
  const gl::Scope scope(context.profiler, "mres.composite");
  gl::bindTexture(kSourceUnit, source.id(), context.nearest);
  level.composed().bind();
  if (level.role() != LevelRole::coarsest) drawInZone();
  glUseProgram(alone_.id());
  context.triangle.draw();
  glDisable(GL_STENCIL_TEST);
}

const CompositePass::ZonePrograms& CompositePass::programsOf(const LevelTargets& level) const {
  if (level.role() == LevelRole::masked) return masked_;
  return level.role() == LevelRole::refinable ? refinable_ : zoned_;
}

void CompositePass::drawOutsideZone(PassContext& context, const LevelTargets& level, const ZoneInputs& inputs,
                                    const gl::Texture2D& zone) {
  const gl::Scope scope(context.profiler, "mres.upsample");
  gl::bindTexture(kZoneUnit, zone.id(), context.nearest);
  gl::bindTexture(kCoarserUnit, inputs.coarser->id(), context.linear);
  level.composed().bind();
  startZone();
  glUseProgram(programsOf(level).outside.id());
  context.triangle.draw();
  glDisable(GL_STENCIL_TEST);
}

void CompositePass::drawZone(PassContext& context, const LevelTargets& level, const ZoneInputs& inputs,
                             const gl::Texture2D& zone) {
  const gl::Texture2D& source = filterAlongX(context, level);
  const gl::Scope scope(context.profiler, "mres.composite");
  gl::bindTexture(kSourceUnit, source.id(), context.nearest);
  gl::bindTexture(kCoarserUnit, inputs.coarser->id(), context.linear);
  gl::bindTexture(kMaskUnit, inputs.mask->id(), context.linear);
  gl::bindTexture(kZoneUnit, zone.id(), context.linear);
  level.composed().bind();
  drawInZone();
  glUseProgram(programsOf(level).blend.id());
  context.triangle.draw();
  glDisable(GL_STENCIL_TEST);
}

}  // namespace mres
