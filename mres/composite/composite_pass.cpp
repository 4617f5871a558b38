#include "mres/composite/composite_pass.h"

#include <array>
#include <string>

#include "mres/mask/stencil_pass.h"

namespace mres {
namespace {

std::string defines(const EffectDescription& effect, LevelRole role, bool progressive = false) {
  const auto define = [](const char* name, int value) {
    return std::string("#define ") + name + ' ' + std::to_string(value) + '\n';
  };
  return define("EFFECT_CHANNELS", effect.channels) + define("FILTERED", effect.filtered ? 1 : 0) +
         define("COARSEST", role == LevelRole::coarsest ? 1 : 0) +
         define("REFINABLE", role == LevelRole::intermediate ? 1 : 0) +
         define("PROGRESSIVE", progressive ? 1 : 0);
}

}  // namespace

CompositePass::CompositePass(const gl::ShaderLibrary& library, const EffectDescription& effect)
    : filtered_(effect.filtered),
      filter_(makePassProgram(library, "mres/filter_horizontal.frag", defines(effect, LevelRole::coarsest))),
      coarsest_(makePassProgram(library, "mres/composite.frag", defines(effect, LevelRole::coarsest))),
      finest_(makeZonePrograms(library, effect, LevelRole::finest)),
      intermediate_(makeZonePrograms(library, effect, LevelRole::intermediate)) {}

CompositePass::ZonePrograms CompositePass::makeZonePrograms(const gl::ShaderLibrary& library,
                                                            const EffectDescription& effect, LevelRole role) {
  return {.blend = makePassProgram(library, "mres/composite.frag", defines(effect, role)),
          .blendProgressively = makePassProgram(library, "mres/composite.frag", defines(effect, role, true)),
          .upsample = makePassProgram(library, "mres/upsample.frag", defines(effect, role))};
}

const gl::Texture2D& CompositePass::filterAlongX(PassContext& context, LevelTargets& level, bool zoned) {
  if (!filtered_) return level.raw().color();
  const gl::Scope scope(context.profiler, "mres.filter");
  level.filteredAlongX().bind();
  if (zoned) {
    constexpr std::array<float, 4> kUndefined{};
    glClearBufferfv(GL_COLOR, 0, kUndefined.data());
    testStencil(GL_EQUAL);
  }
  gl::bindTexture(kSourceUnit, level.raw().color().id(), context.nearest);
  glUseProgram(filter_.id());
  context.triangle.draw();
  glDisable(GL_STENCIL_TEST);
  return level.filteredAlongX().color();
}

void CompositePass::drawCoarsest(PassContext& context, LevelTargets& level) {
  const gl::Texture2D& source = filterAlongX(context, level, false);
  const gl::Scope scope(context.profiler, "mres.composite");
  gl::bindTexture(kSourceUnit, source.id(), context.nearest);
  level.composed().bind();
  glUseProgram(coarsest_.id());
  context.triangle.draw();
}

void CompositePass::draw(PassContext& context, LevelTargets& level, const ZoneInputs& zone) {
  const gl::Texture2D& source = filterAlongX(context, level, true);
  const gl::Scope scope(context.profiler, "mres.composite");
  const ZonePrograms& programs = level.role() == LevelRole::intermediate ? intermediate_ : finest_;
  gl::bindTexture(kSourceUnit, source.id(), context.nearest);
  gl::bindTexture(kCoarserUnit, zone.coarser->id(), context.linear);
  gl::bindTexture(kMaskUnit, zone.mask->id(), context.linear);
  if (zone.refine != nullptr) gl::bindTexture(kRefineUnit, zone.refine->id(), context.linear);
  level.composed().bind();
  testStencil(GL_NOTEQUAL);
  glUseProgram(programs.upsample.id());
  context.triangle.draw();
  testStencil(GL_EQUAL);
  glUseProgram(zone.refine != nullptr ? programs.blendProgressively.id() : programs.blend.id());
  context.triangle.draw();
  glDisable(GL_STENCIL_TEST);
}

}  // namespace mres
