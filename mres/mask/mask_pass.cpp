#include "mres/mask/mask_pass.h"

#include <cmath>

namespace mres {
namespace {

/// Half a step of an eight-bit mask.
constexpr double kSmallestWeight = 0.5 / 255.0;

void ensure(gl::RenderTarget& target, glm::ivec2 size, const char* label) {
  if (target.size() != size) target = gl::RenderTarget(size, {GL_R8}, 0, label);
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

MaskPass::MaskPass(const gl::ShaderLibrary& library)
    : downsampleProgram_(makePassProgram(library, "mres/mask_downsample.frag")),
      blurProgram_(makePassProgram(library, "mres/mask_blur.frag")) {}

void MaskPass::draw(PassContext& context, const gl::Texture2D& edges, const LevelPlan& plan) {
  const gl::Scope scope(context.profiler, "mres.masks");
  const glm::ivec2 fullSize = plan.levels.front().size;
  const gl::Texture2D* source = &edges;
  int finerLevel = -1;
  std::size_t planned = 0;
  for (int index = 0; planned + 1 < plan.levels.size(); ++index) {
    Level& level = levels_.at(slot(index));
    if (index > 0) {
      ensure(level.edges, levelSize(fullSize, index + 1), "mres.edges");
      downsample(context, *source, level.edges);
      source = &level.edges.color();
    }
    if (plan.levels[planned].index != index) continue;

    ensure(level.blurredAlongX, source->size(), "mres.masks");
    ensure(level.mask, source->size(), "mres.masks");
    // A texel of the mask is two pixels of the level: a variance in pixels^2 is a quarter of it in texels^2.
    const float variance = plan.levels[planned].settings.maskVariance * 0.25f;
    const bool first = finerLevel < 0;
    blur(context, *source, variance, first ? 0 : 1 << (index - finerLevel), first ? 0 : mask(finerLevel).id(),
         level);
    finerLevel = index;
    ++planned;
  }
}

void MaskPass::downsample(PassContext& context, const gl::Texture2D& source, gl::RenderTarget& target) {
  gl::bindTexture(kSourceUnit, source.id(), context.nearest);
  glUseProgram(downsampleProgram_.id());
  target.bind();
  context.triangle.draw();
}

void MaskPass::blur(PassContext& context, const gl::Texture2D& source, float variance, int finerRatio,
                    GLuint finerMask, Level& level) {
  params::MaskBlurParams params = gaussian(variance);
  glUseProgram(blurProgram_.id());
  gl::bindTexture(kMaskUnit, finerMask, context.nearest);

  params.axis = {1, 0};
  params_.upload(params);
  params_.bind(kPassBlock);
  gl::bindTexture(kSourceUnit, source.id(), context.nearest);
  level.blurredAlongX.bind();
  context.triangle.draw();

  params.axis = {0, 1};
  params.finerRatio = finerRatio;
  params_.upload(params);
  gl::bindTexture(kSourceUnit, level.blurredAlongX.color().id(), context.nearest);
  level.mask.bind();
  context.triangle.draw();
}

std::size_t MaskPass::bytes() const {
  std::size_t sum = 0;
  for (const Level& level : levels_)
    sum += level.edges.bytes() + level.blurredAlongX.bytes() + level.mask.bytes();
  return sum;
}

}  // namespace mres
