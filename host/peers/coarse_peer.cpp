#include "host/peers/coarse_peer.h"

#include "mres/level/level_targets.h"

namespace host {

CoarsePeer::CoarsePeer(const mres::EffectDescription& effect, const PeerOptions& options, int level,
                       Upsampling upsampling)
    : PeerBase(effect, options),
      coarse_(level),
      filter_(library(), effect),
      upsample_(library(), effect, upsampling) {}

const mres::gl::Texture2D& CoarsePeer::draw(const PeerFrame& frame) {
  coarse_.draw(frame, filter_);
  ensure(result_, frame.size, mres::resultFormat(frame.description()), "mres.composite");
  block_.bind(frame, 0, coarse_.index());
  upsample_.draw(frame, coarse_.color(), result_);
  return result_.color();
}

double CoarsePeer::work() {
  return pixelShare(coarse_.size(), result_.size());
}

std::vector<const mres::gl::RenderTarget*> CoarsePeer::targets() const {
  std::vector<const mres::gl::RenderTarget*> all = coarse_.targets();
  all.push_back(&result_);
  return all;
}

}  // namespace host
