#include "mres/composite/composite_pass.h"

#include <array>
#include <string>

#include "mres/mask/stencil_pass.h"

namespace mres {
namespace {

std::string defines(const EffectDescription& effect, bool coarsest) {
  return "#define EFFECT_CHANNELS " + std::to_string(effect.channels) + "\n#define FILTERED " +
         std::to_string(effect.filtered ? 1 : 0) + "\n#define COARSEST " + std::to_string(coarsest ? 1 : 0) +
         "\n";
}

}  // namespace

CompositePass::CompositePass(const gl::ShaderLibrary& library, const EffectDescription& effect)
    : filtered_(effect.filtered),
      filter_(makePassProgram(library, "mres/filter_horizontal.frag", defines(effect, false))),
      coarsest_(makePassProgram(library, "mres/composite.frag", defines(effect, true))),
      blend_(makePassProgram(library, "mres/composite.frag", defines(effect, false))),
      upsample_(makePassProgram(library, "mres/upsample.frag")) {}

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

void CompositePass::draw(PassContext& context, LevelTargets& level, const gl::Texture2D& coarser,
                         const gl::Texture2D& mask) {
  const gl::Texture2D& source = filterAlongX(context, level, true);
  const gl::Scope scope(context.profiler, "mres.composite");
  gl::bindTexture(kSourceUnit, source.id(), context.nearest);
  gl::bindTexture(kCoarserUnit, coarser.id(), context.linear);
  gl::bindTexture(kMaskUnit, mask.id(), context.linear);
  level.composed().bind();
  testStencil(GL_NOTEQUAL);
  glUseProgram(upsample_.id());
  context.triangle.draw();
  testStencil(GL_EQUAL);
  glUseProgram(blend_.id());
  context.triangle.draw();
  glDisable(GL_STENCIL_TEST);
}

}  // namespace mres
