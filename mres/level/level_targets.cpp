#include "mres/level/level_targets.h"

namespace mres {
namespace {

/// Jitter needs a filter that takes the mean over it: one whose period is even.
bool isJittered(const PlannedLevel& level, bool filtered) {
  return filtered && level.index > 0 && level.settings.noisePeriod % 2 == 0;
}

/// Where a size is no multiple of the stride, the coarser level's last pixel is evaluated at the last pixel
/// of the screen, nearer to its neighbour than the others are: how pixels in between count
/// (LevelParams::lastInterval).
glm::vec4 lastInterval(const PlannedLevel& coarser, int jitter, glm::ivec2 fullSize) {
  const int stride = 1 << coarser.index;
  const auto regular = static_cast<float>(stride);
  const float meanOfJitter = 0.5f * static_cast<float>(jitter);
  const glm::vec2 beforeLast = glm::vec2((coarser.size - 2) * stride + stride / 2) - meanOfJitter;
  const glm::vec2 length = glm::min(glm::vec2(regular), glm::vec2(fullSize - 1) - beforeLast);
  return {beforeLast, regular / length - 1.0f};
}

}  // namespace

GLenum levelFormat(const EffectDescription& effect) {
  return effect.channels == 1 ? GL_RG16F : GL_RGBA16F;
}

GLenum resultFormat(const EffectDescription& effect) {
  return effect.channels == 1 ? GL_R16F : GL_RGBA16F;
}

void LevelTargets::ensure(const EffectDescription& effect, glm::ivec2 size, LevelRole role) {
  if (targets_.raw.size() != size || !serves(role)) {
    targets_ = make(effect, size, role);
    madeFor_ = role;
  }
  role_ = role;
}

void LevelTargets::fillAlone(const EffectDescription& effect, glm::ivec2 size, glm::vec4 value) {
  if (composed().size() != size) {
    targets_ = {};
    targets_.composed = gl::RenderTarget(size, {resultFormat(effect)}, 0, "mres.composite");
  }
  composed().fill(value);
}

// What has a zone can do without: falling back to the plain effect, and coming back, allocates nothing.
bool LevelTargets::serves(LevelRole role) const {
  const bool plainZone = madeFor_ == LevelRole::zoned || madeFor_ == LevelRole::masked;
  return role == madeFor_ || (plainZone && role != LevelRole::refinable);
}

LevelTargets::Targets LevelTargets::make(const EffectDescription& effect, glm::ivec2 size, LevelRole role) {
  const bool zoned = role != LevelRole::coarsest;
  Targets targets;
  if (zoned) targets.stencil = gl::StencilBuffer(size, "mres.stencil");
  const auto makeTarget = [&](std::initializer_list<GLenum> formats, const char* label) {
    return zoned ? gl::RenderTarget(size, formats, targets.stencil, label)
                 : gl::RenderTarget(size, formats, 0, label);
  };
  targets.raw = makeTarget({levelFormat(effect)}, "mres.level");
  if (effect.filtered) targets.filteredAlongX = makeTarget({levelFormat(effect)}, "mres.filter");
  targets.composed = role == LevelRole::refinable
                         ? makeTarget({resultFormat(effect), GL_R8}, "mres.composite")
                         : makeTarget({resultFormat(effect)}, "mres.composite");
  return targets;
}

std::size_t LevelTargets::bytes() const {
  return targets_.stencil.bytes() + raw().bytes() + filteredAlongX().bytes() + composed().bytes();
}

void LevelTargets::fill(float value) const {
  for (const gl::RenderTarget* target : {&raw(), &filteredAlongX(), &composed()}) target->fill(value);
}

params::LevelParams levelParams(const LevelNeighbours& level, glm::ivec2 fullSize, float refineThreshold) {
  params::LevelParams params{};
  const int stride = 1 << level.level.index;
  params.levelSize = level.level.size;
  params.levelStride = stride;
  params.levelHalfStride = stride / 2;
  params.levelJitter = isJittered(level.level, level.filtered) ? 1 : 0;
  if (level.coarser != nullptr) {
    // Texel p of the coarser level sits at full-resolution pixel p * stride + stride / 2 - jitter / 2, so
    // pixel x lies at texel (x - stride / 2 + jitter / 2) / stride; texel centres are half a texel on, which
    // cancels.
    const PlannedLevel& coarser = *level.coarser;
    params.coarserFromPixel = 1.0f / (static_cast<float>(1 << coarser.index) * glm::vec2(coarser.size));
    params.coarserStride = 1 << coarser.index;
    params.coarserJitter = isJittered(coarser, level.filtered) ? 1 : 0;
    params.lastInterval = lastInterval(coarser, params.coarserJitter, fullSize);
  }
  params.maskFromPixel =
      1.0f / (static_cast<float>(2 * stride) * glm::vec2(levelSize(fullSize, level.level.index + 1)));
  params.blendWeight = level.level.settings.blendWeight;
  params.noisePeriod = level.level.settings.noisePeriod;
  const glm::ivec2 blocks = (level.level.size + ZONE_BLOCK - 1) / ZONE_BLOCK;
  params.zoneFromPixel = 1.0f / static_cast<float>(ZONE_BLOCK) / glm::vec2(blocks);
  params.refineThreshold = refineThreshold;
  return params;
}

}  // namespace mres
