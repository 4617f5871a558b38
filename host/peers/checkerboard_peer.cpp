#include "host/peers/checkerboard_peer.h"

#include "host/peers/peer_shaders.h"
#include "mres/level/level_targets.h"
#include "shaders/peers/peer_blocks.h"

namespace host {
namespace {

glm::ivec2 packedSize(glm::ivec2 size) {
  const glm::ivec2 blocks = (size + CHECKERBOARD_BLOCK - 1) / CHECKERBOARD_BLOCK;
  return glm::ivec2((blocks.x + 1) / 2, blocks.y) * CHECKERBOARD_BLOCK;
}

}  // namespace

CheckerboardPeer::CheckerboardPeer(const mres::EffectDescription& effect, const PeerOptions& options)
    : PeerBase(effect, options, "peers/effect_checkerboard.frag"),
      filter_(library(), effect),
      fill_(mres::makePassProgram(library(), "peers/fill_checkerboard.frag", effectDefines(effect))) {}

void CheckerboardPeer::fill(const PeerFrame& frame, const mres::gl::RenderTarget& target) const {
  const mres::gl::Scope scope(frame.context.profiler, "mres.fill");
  mres::gl::bindTexture(mres::kSourceUnit, evaluated_.color().id(), frame.context.nearest);
  frame.use(fill_);
  target.bind();
  frame.context.triangle.draw();
}

const mres::gl::Texture2D& CheckerboardPeer::draw(const PeerFrame& frame) {
  const mres::EffectDescription& effect = frame.description();
  ensure(evaluated_, packedSize(frame.size), mres::levelFormat(effect), "mres.level");
  ensure(result_, frame.size, mres::resultFormat(effect), "mres.composite");
  block_.bind(frame, 0);
  frame.drawEffect(evaluated_, 0);
  if (!effect.filtered) {
    fill(frame, result_);
    return result_.color();
  }
  ensure(filled_, frame.size, mres::levelFormat(effect), "mres.fill");
  ensure(filteredAlongX_, frame.size, mres::levelFormat(effect), "mres.filter");
  fill(frame, filled_);
  filter_.alongX(frame, filled_.color(), filteredAlongX_);
  filter_.alongY(frame, filteredAlongX_.color(), result_);
  return result_.color();
}

double CheckerboardPeer::work() {
  return pixelShare(evaluated_.size(), result_.size());
}

std::vector<const mres::gl::RenderTarget*> CheckerboardPeer::targets() const {
  return {&evaluated_, &filled_, &filteredAlongX_, &result_};
}

}  // namespace host
