#pragma once

#include "host/peers/filter_pass.h"
#include "host/peers/level_block.h"
#include "host/peers/peer_base.h"

namespace host {

/// The effect at half of the full resolution's pixels, a checkerboard of small blocks, the other half filled
/// from them (shaders/peers/checkerboard.glsl).
class CheckerboardPeer final : public PeerBase {
 public:
  CheckerboardPeer(const mres::EffectDescription& effect, const PeerOptions& options);
  [[nodiscard]] double work() override;

 private:
  const mres::gl::Texture2D& draw(const PeerFrame& frame) override;
  [[nodiscard]] std::vector<const mres::gl::RenderTarget*> targets() const override;
  void fill(const PeerFrame& frame, const mres::gl::RenderTarget& target) const;

  FilterPass filter_;
  mres::gl::Program fill_;
  LevelBlock block_;
  mres::gl::RenderTarget evaluated_;  // packed
  mres::gl::RenderTarget filled_;
  mres::gl::RenderTarget filteredAlongX_;
  mres::gl::RenderTarget result_;
};

}  // namespace host
