#include "mres/mask/preview_pass.h"

#include "mres/level/effect_program.h"
#include "mres/level/level_targets.h"
#include "mres/plan/level_plan.h"

namespace mres {
namespace {

/// The level at whose pixels effects are previewed.
constexpr int kPreviewLevel = 1;

gl::Program makeDifference(const gl::ShaderLibrary& library, bool withGeometry) {
  return makePassProgram(library, "mres/preview_edges.frag",
                         withGeometry ? "#define WITH_GEOMETRY 1\n" : "#define WITH_GEOMETRY 0\n");
}

}  // namespace

PreviewPass::PreviewPass(const gl::ShaderLibrary& library, const EffectDescription& effect)
    : filtered_(effect.filtered) {
  if (!effect.hasPreview) return;
  preview_ = makeEffectProgram(library, effect, "mres/preview.frag");
  difference_ = makeDifference(library, false);
  differenceAndGeometry_ = makeDifference(library, true);
}

void PreviewPass::setUp(Effect& effect) {
  if (isSetUp_ || !preview_) return;
  glUseProgram(preview_.id());
  effect.setUp(preview_);
  isSetUp_ = true;
}

void PreviewPass::ensureTargets(glm::ivec2 fullSize) {
  const PlannedLevel level{kPreviewLevel, levelSize(fullSize, kPreviewLevel), {}};
  if (edges_.size() == level.size) return;
  bounds_ = gl::RenderTarget(level.size, {GL_RG8}, 0, "mres.preview");
  edges_ = gl::RenderTarget(level.size, {GL_RG8}, 0, "mres.preview");
  levelBlock_.upload(levelParams({level, nullptr, filtered_}, fullSize, 0.0f));
}

void PreviewPass::drawBounds(PassContext& context) {
  levelBlock_.bind(kLevelBlock);
  bounds_.bind();
  glUseProgram(preview_.id());
  context.triangle.draw();
}

void PreviewPass::draw(PassContext& context, float refineThreshold, glm::ivec2 fullSize,
                       const gl::Texture2D* geometryEdges) {
  const gl::Scope scope(context.profiler, "mres.preview");
  ensureTargets(fullSize);
  drawBounds(context);
  gl::bindTexture(kSourceUnit, bounds_.color().id(), context.nearest);
  if (geometryEdges != nullptr) gl::bindTexture(kMaskUnit, geometryEdges->id(), context.nearest);
  const gl::Program& program = geometryEdges != nullptr ? differenceAndGeometry_ : difference_;
  glUseProgram(program.id());
  glUniform1f(program.uniformLocation("threshold"), refineThreshold);
  edges_.bind();
  context.triangle.draw();
}

void PreviewPass::fill(float value) const {
  bounds_.fill(value);
  edges_.fill(value);
}

}  // namespace mres
