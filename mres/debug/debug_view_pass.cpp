#include "mres/debug/debug_view_pass.h"

namespace mres {
namespace {

constexpr GLuint kHalfZoneUnit = 3;
constexpr GLuint kQuarterZoneUnit = 4;

}  // namespace

DebugViewPass::DebugViewPass(const gl::ShaderLibrary& library)
    : edges_(makePassProgram(library, "mres/debug_view.frag", "#define VIEW_LEVELS 0\n")),
      levels_(makePassProgram(library, "mres/debug_view.frag", "#define VIEW_LEVELS 1\n")) {
  levels_.setTextureUnit("halfZone", kHalfZoneUnit);
  levels_.setTextureUnit("quarterZone", kQuarterZoneUnit);
}

const gl::Texture2D& DebugViewPass::drawEdges(PassContext& context, const EdgeImages& edges,
                                              glm::ivec2 fullSize) {
  gl::bindTexture(kSourceUnit, edges.geometry == nullptr ? 0 : edges.geometry->id(), context.nearest);
  gl::bindTexture(kMaskUnit, edges.effect == nullptr ? 0 : edges.effect->id(), context.nearest);
  draw(context, edges_, fullSize);
  return target_.color();
}

const gl::Texture2D& DebugViewPass::drawLevels(PassContext& context, const ZonePass& zones,
                                               const LevelPlan& plan) {
  constexpr std::array<GLuint, kMaxLevels - 1> kUnits = {kSourceUnit, kHalfZoneUnit, kQuarterZoneUnit};
  glm::ivec4 used(0);
  for (std::size_t i = 0; i + 1 < plan.levels.size(); ++i) {
    const int index = plan.levels[i].index;
    used[index] = 1;
    gl::bindTexture(kUnits.at(static_cast<std::size_t>(index)), zones.zone(index).id(), context.nearest);
  }
  glUseProgram(levels_.id());
  glUniform4iv(levels_.uniformLocation("levelUsed"), 1, &used.x);
  glUniform1i(levels_.uniformLocation("coarsestLevel"), plan.levels.back().index);
  draw(context, levels_, plan.levels.front().size);
  return target_.color();
}

void DebugViewPass::draw(PassContext& context, const gl::Program& program, glm::ivec2 fullSize) {
  if (target_.size() != fullSize) target_ = gl::RenderTarget(fullSize, {GL_RGBA8}, 0, "mres.debug");
  glUseProgram(program.id());
  target_.bind();
  context.triangle.draw();
}

}  // namespace mres
