#include "host/peers/interleaved_peer.h"

#include "host/peers/peer_shaders.h"
#include "mres/level/level_targets.h"
#include "shaders/peers/peer_blocks.h"

namespace host {
namespace {

/// Tiles of whole pixels: a few more than there are where the size is no multiple of the phases.
glm::ivec2 sizeOfPhases(glm::ivec2 size) {
  return (size + INTERLEAVED_PHASES - 1) / INTERLEAVED_PHASES * INTERLEAVED_PHASES;
}

}  // namespace

InterleavedPeer::InterleavedPeer(const mres::EffectDescription& effect, const PeerOptions& options)
    : PeerBase(effect, options, "peers/effect_phases.frag"),
      filter_(library(), effect),
      gather_(mres::makePassProgram(library(), "peers/gather_phases.frag", effectDefines(effect))) {}

void InterleavedPeer::gather(const PeerFrame& frame, const mres::gl::RenderTarget& target) const {
  const mres::gl::Scope scope(frame.context.profiler, "mres.gather");
  mres::gl::bindTexture(mres::kSourceUnit, phases_.color().id(), frame.context.nearest);
  frame.use(gather_);
  target.bind();
  frame.context.triangle.draw();
}

const mres::gl::Texture2D& InterleavedPeer::draw(const PeerFrame& frame) {
  const mres::EffectDescription& effect = frame.description();
  ensure(phases_, sizeOfPhases(frame.size), mres::levelFormat(effect), "mres.level");
  ensure(result_, frame.size, mres::resultFormat(effect), "mres.composite");
  block_.bind(frame, 0);
  frame.drawEffect(phases_, 0);
  if (!effect.filtered) {
    gather(frame, result_);
    return result_.color();
  }
  ensure(filteredAlongX_, frame.size, mres::levelFormat(effect), "mres.filter");
  gather(frame, filteredAlongX_);
  filter_.alongY(frame, filteredAlongX_.color(), result_);
  return result_.color();
}

double InterleavedPeer::work() {
  return pixelShare(phases_.size(), result_.size());
}

std::vector<const mres::gl::RenderTarget*> InterleavedPeer::targets() const {
  return {&phases_, &filteredAlongX_, &result_};
}

}  // namespace host
