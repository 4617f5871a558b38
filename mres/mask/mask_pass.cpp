#include "mres/mask/mask_pass.h"

#include <algorithm>
#include <cmath>

namespace mres {
namespace {

/// Half a step of an eight-bit mask.
constexpr double kSmallestWeight = 0.5 / 255.0;

void ensure(gl::RenderTarget& target, glm::ivec2 size, GLenum format, const char* label) {
  if (target.size() != size) target = gl::RenderTarget(size, {format}, 0, label);
}

}  // namespace

params::MaskBlurParams gaussian(float variance) {
  std::array<double, MASK_BLUR_MAX_RADIUS + 1> weights{1.0};
  double sum = 1.0;
  int radius = 0;
  for (int distance = 1; distance <= MASK_BLUR_MAX_RADIUS && variance > 0.0f; ++distance) {
    const double weight = std::exp(-0.5 * distance * distance / static_cast<double>(variance));
    if (weight < kSmallestWeight * (sum + 2.0 * weight)) break;
    weights.at(static_cast<std::size_t>(distance)) = weight;
    sum += 2.0 * weight;
    radius = distance;
  }
  params::MaskBlurParams params{};
  params.radius = radius;
  for (int distance = 0; distance <= radius; ++distance) {
    const auto index = static_cast<std::size_t>(distance);
    params.weights[distance / 4][distance % 4] = static_cast<float>(weights.at(index) / sum);
  }
  return params;
}

int solidRadius(const params::MaskBlurParams& kernel) {
  // Around a lone edge texel the blurred mask is the product of two weights, the first of them rounded to
  // eight bits: its support is the square up to the distance where that still rounds to more than zero.
  int solid = 0;
  while (solid < kernel.radius) {
    const auto next = static_cast<double>(kernel.weights[(solid + 1) / 4][(solid + 1) % 4]);
    if ((next - kSmallestWeight) * next < kSmallestWeight) break;
    ++solid;
  }
  return solid;
}

MaskPass::MaskPass(const gl::ShaderLibrary& library)
    : downsampleProgram_(makePassProgram(library, "mres/mask_downsample.frag", "#define JOIN_COARSER 0\n")),
      downsampleJoinProgram_(
          makePassProgram(library, "mres/mask_downsample.frag", "#define JOIN_COARSER 1\n")),
      blurProgram_(makePassProgram(library, "mres/mask_blur.frag", "#define JOIN_FINER 0\n")),
      blurJoinProgram_(makePassProgram(library, "mres/mask_blur.frag", "#define JOIN_FINER 1\n")) {}

void MaskPass::drawEdges(PassContext& context, const MaskSources& sources, const LevelPlan& plan) {
  const gl::Scope scope(context.profiler, "mres.masks");
  const gl::Texture2D* source = sources.edges;
  int index = 0;
  for (std::size_t planned = 0; planned + 1 < plan.levels.size(); ++planned) {
    const PlannedLevel& level = plan.levels[planned];
    for (; index < level.index; ++index) {
      const gl::Texture2D* joined = sources.joined.at(slot(index + 1));
      source = &edgesOf(context, index + 1, *source, joined, plan.levels.front().size);
    }
    edges_.at(slot(level.index)) = source;
  }
}

void MaskPass::drawBlurred(PassContext& context, const LevelPlan& plan) {
  const gl::Scope scope(context.profiler, "mres.masks");
  const Level* finer = nullptr;
  for (std::size_t planned = 0; planned + 1 < plan.levels.size(); ++planned) {
    const PlannedLevel& level = plan.levels[planned];
    Level& masked = levels_.at(slot(level.index));
    setKernel(masked, level.settings.maskVariance,
              planned == 0 ? 0 : 1 << (level.index - plan.levels[planned - 1].index));
    blur(context, edges(level.index), masked, finer);
    finer = &masked;
  }
}

const gl::Texture2D& MaskPass::edgesOf(PassContext& context, int level, const gl::Texture2D& finerEdges,
                                       const gl::Texture2D* joined, glm::ivec2 fullSize) {
  gl::RenderTarget& target = levels_.at(slot(level)).edges;
  ensure(target, levelSize(fullSize, level + 1), GL_RG8, "mres.edges");
  gl::bindTexture(kSourceUnit, finerEdges.id(), context.nearest);
  if (joined != nullptr) gl::bindTexture(kMaskUnit, joined->id(), context.nearest);
  glUseProgram(joined != nullptr ? downsampleJoinProgram_.id() : downsampleProgram_.id());
  target.bind();
  context.triangle.draw();
  return target.color();
}

// Kernels hardly ever change: they stay on the GPU.
void MaskPass::setKernel(Level& level, float variance, int finerRatio) {
  if (level.variance == variance && level.kernel.finerRatio == finerRatio) return;
  // A texel of the mask is two pixels of the level: a variance in pixels^2 is a quarter of it in texels^2.
  level.kernel = gaussian(variance * 0.25f);
  level.kernel.finerRatio = finerRatio;
  level.variance = variance;
  for (int axis = 0; axis < 2; ++axis) {
    level.kernel.axis = {1 - axis, axis};
    level.kernelBlocks.at(static_cast<std::size_t>(axis)).upload(level.kernel);
  }
}

void MaskPass::blur(PassContext& context, const gl::Texture2D& source, Level& level, const Level* finer) {
  ensure(level.blurredAlongX, source.size(), GL_R8, "mres.masks");
  ensure(level.mask, source.size(), GL_R8, "mres.masks");

  level.kernelBlocks[0].bind(kPassBlock);
  gl::bindTexture(kSourceUnit, source.id(), context.nearest);
  glUseProgram(blurProgram_.id());
  level.blurredAlongX.bind();
  context.triangle.draw();

  level.kernelBlocks[1].bind(kPassBlock);
  gl::bindTexture(kSourceUnit, level.blurredAlongX.color().id(), context.nearest);
  level.reach = level.kernel.radius;
  if (finer != nullptr && solidRadius(level.kernel) * level.kernel.finerRatio < finer->reach) {
    const int ratio = level.kernel.finerRatio;
    level.reach = std::max(level.reach, (finer->reach + ratio - 1) / ratio);
    gl::bindTexture(kMaskUnit, finer->mask.color().id(), context.nearest);
    glUseProgram(blurJoinProgram_.id());
  }
  level.mask.bind();
  context.triangle.draw();
}

void MaskPass::fill(float value) const {
  for (const Level& level : levels_) {
    for (const gl::RenderTarget* target : {&level.edges, &level.blurredAlongX, &level.mask}) {
      target->fill(value);
    }
  }
}

std::size_t MaskPass::bytes() const {
  std::size_t sum = 0;
  for (const Level& level : levels_)
    sum += level.edges.bytes() + level.blurredAlongX.bytes() + level.mask.bytes();
  return sum;
}

}  // namespace mres
