#pragma once

#include "host/peers/filter_pass.h"
#include "host/peers/level_block.h"
#include "host/peers/peer_base.h"

namespace host {

/// The effect at every pixel of the full resolution, in tiles of one direction of the noise each: the values
/// are those of the reference, but the order of evaluation is kinder to caches (shaders/peers/phases.glsl).
class InterleavedPeer final : public PeerBase {
 public:
  InterleavedPeer(const mres::EffectDescription& effect, const PeerOptions& options);
  [[nodiscard]] double work() override;

 private:
  const mres::gl::Texture2D& draw(const PeerFrame& frame) override;
  [[nodiscard]] std::vector<const mres::gl::RenderTarget*> targets() const override;
  void gather(const PeerFrame& frame, const mres::gl::RenderTarget& target) const;

  FilterPass filter_;
  mres::gl::Program gather_;
  LevelBlock block_;
  mres::gl::RenderTarget phases_;
  mres::gl::RenderTarget filteredAlongX_;
  mres::gl::RenderTarget result_;
};

}  // namespace host
