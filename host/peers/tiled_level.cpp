#include "host/peers/tiled_level.h"

#include "mres/level/level_targets.h"

namespace host {

TiledLevel::Targets TiledLevel::make(const mres::EffectDescription& effect, glm::ivec2 size) const {
  const GLenum format = mres::levelFormat(effect);
  const GLenum pictureFormat = index_ > 0 ? format : mres::resultFormat(effect);
  Targets targets;
  targets.stencil = mres::gl::StencilBuffer(size, "mres.stencil");
  targets.raw = mres::gl::RenderTarget(size, {format}, targets.stencil, "mres.level");
  if (effect.filtered)
    targets.filteredAlongX = mres::gl::RenderTarget(size, {format}, targets.stencil, "mres.filter");
  targets.picture = mres::gl::RenderTarget(size, {pictureFormat}, targets.stencil, "mres.composite");
  return targets;
}

void TiledLevel::prepare(const PeerFrame& frame) {
  const glm::ivec2 size = frame.level(index_).size;
  if (picture().size() != size) targets_ = make(frame.description(), size);
  block_.bind(frame, index_, index_ + 1);
}

}  // namespace host
