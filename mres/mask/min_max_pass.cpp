#include "mres/mask/min_max_pass.h"

#include "mres/mask/edge_pass.h"

namespace mres {
namespace {

constexpr std::array<GLuint, 3> kRangeUnits = {kSourceUnit, kCoarserUnit, kMaskUnit};

gl::Program makeProgram(const gl::ShaderLibrary& library, const char* fragment, const char* defines = "") {
  gl::Program program = makePassProgram(library, fragment, defines);
  program.setTextureUnit("depthRangeTexture", kRangeUnits[0]);
  program.setTextureUnit("leastNormalTexture", kRangeUnits[1]);
  program.setTextureUnit("largestNormalTexture", kRangeUnits[2]);
  return program;
}

void bindRanges(const PassContext& context, const gl::RenderTarget& ranges) {
  for (std::size_t i = 0; i < kRangeUnits.size(); ++i) {
    gl::bindTexture(kRangeUnits.at(i), ranges.color(i).id(), context.nearest);
  }
}

}  // namespace

MinMaxPass::MinMaxPass(const gl::ShaderLibrary& library)
    : lowest_(makeProgram(library, "mres/min_max.frag", "#define LOWEST 1\n")),
      reduce_(makeProgram(library, "mres/min_max.frag", "#define LOWEST 0\n")),
      edgesProgram_(makeProgram(library, "mres/min_max_edges.frag")) {}

void MinMaxPass::draw(PassContext& context, const MaskSettings& settings, const params::FrameParams& frame,
                      const LevelPlan& plan) {
  const gl::Scope scope(context.profiler, "mres.edges");
  params_.upload(edgesParams(settings, frame));
  params_.bind(kPassBlock);
  for (int level = 0; level < plan.levels.back().index; ++level) drawRanges(context, level, frame.size);
  for (std::size_t i = 0; i + 1 < plan.levels.size(); ++i) {
    drawEdges(context, plan.levels[i].index, plan.levels[i + 1].index, frame.size);
  }
}

void MinMaxPass::drawRanges(PassContext& context, int level, glm::ivec2 fullSize) {
  gl::RenderTarget& target = levels_.at(slot(level)).ranges;
  const glm::ivec2 size = levelSize(fullSize, level + 1);
  if (target.size() != size) {
    target = gl::RenderTarget(size, {GL_RG32F, GL_RGBA16F, GL_RGBA16F}, 0, "mres.minMax");
  }
  if (level > 0) bindRanges(context, levels_.at(slot(level - 1)).ranges);
  glUseProgram(level > 0 ? reduce_.id() : lowest_.id());
  target.bind();
  context.triangle.draw();
}

void MinMaxPass::drawEdges(PassContext& context, int level, int coarser, glm::ivec2 fullSize) {
  gl::RenderTarget& target = levels_.at(slot(level)).edges;
  const glm::ivec2 size = levelSize(fullSize, level + 1);
  if (target.size() != size) target = gl::RenderTarget(size, {GL_RG8}, 0, "mres.edges");
  bindRanges(context, levels_.at(slot(coarser - 1)).ranges);
  glUseProgram(edgesProgram_.id());
  glUniform1i(edgesProgram_.uniformLocation("ratio"), 1 << (coarser - 1 - level));
  target.bind();
  context.triangle.draw();
}

void MinMaxPass::fill(float value) const {
  for (const Level& level : levels_) {
    level.ranges.fill(value);
    level.edges.fill(value);
  }
}

std::size_t MinMaxPass::bytes() const {
  std::size_t sum = 0;
  for (const Level& level : levels_) sum += level.ranges.bytes() + level.edges.bytes();
  return sum;
}

}  // namespace mres
