#include "host/peers/adaptive_tiles_peer.h"

namespace host {
namespace {

/// The RMS that a level of an eighth of the resolution may err by in a tile, for each of the whole picture:
/// measured with SSAO in the hall at 1920x1080.
constexpr float kThresholdPerError = 1.5f;

}  // namespace

AdaptiveTilesPeer::AdaptiveTilesPeer(const mres::EffectDescription& effect, const PeerOptions& options)
    : PeerBase(effect, options),
      threshold_(options.errorBudget * kThresholdPerError),
      measureWork_(options.measureWork),
      filter_(library(), effect),
      rates_(library(), effect),
      aroundTiles_(library(), effect, Upsampling::joint) {}

void AdaptiveTilesPeer::drawEffect(const PeerFrame& frame, const TiledLevel& level) {
  if (measureWork_) coverage_.begin(frame.level(level.index()));
  frame.drawEffect(level.raw(), level.index(), true);
  if (measureWork_) coverage_.end();
}

void AdaptiveTilesPeer::drawTiles(const PeerFrame& frame, TiledLevel& level,
                                  const mres::gl::Texture2D& coarser) {
  level.prepare(frame);
  rates_.startZone(frame, level.picture());
  aroundTiles_.draw(frame, coarser, level.picture(), true);
  drawEffect(frame, level);
  const bool filtered = frame.description().filtered;
  if (filtered) filter_.alongX(frame, level.raw().color(), level.filteredAlongX(), true);
  const mres::gl::RenderTarget& source = filtered ? level.filteredAlongX() : level.raw();
  filter_.alongY(frame, source.color(), level.picture(), true);
}

const mres::gl::Texture2D& AdaptiveTilesPeer::draw(const PeerFrame& frame) {
  quarter_.draw(frame, filter_);
  rates_.draw(frame, quarter_.color(), threshold_);
  drawTiles(frame, half_, quarter_.color());
  drawTiles(frame, full_, half_.picture().color());
  return full_.picture().color();
}

double AdaptiveTilesPeer::work() {
  double sum = pixelShare(quarter_.size(), full_.size());
  for (const TiledLevel* level : {&half_, &full_})
    sum += coverage_.of(level->index()) * pixelShare(level->size(), full_.size());
  return sum;
}

std::size_t AdaptiveTilesPeer::bytes() const {
  return PeerBase::bytes() + half_.stencilBytes() + full_.stencilBytes();
}

std::vector<const mres::gl::RenderTarget*> AdaptiveTilesPeer::targets() const {
  std::vector<const mres::gl::RenderTarget*> all = quarter_.targets();
  for (const TiledLevel* level : {&half_, &full_}) {
    const std::vector<const mres::gl::RenderTarget*> own = level->targets();
    all.insert(all.end(), own.begin(), own.end());
  }
  all.push_back(&rates_.rates());
  return all;
}

}  // namespace host
