#pragma once

#include "host/peers/level_picture.h"
#include "host/peers/peer_base.h"
#include "host/peers/upsample_pass.h"

namespace host {

/// The effect at every pixel of one coarse level, upsampled: what engines have as half resolution.
class CoarsePeer final : public PeerBase {
 public:
  CoarsePeer(const mres::EffectDescription& effect, const PeerOptions& options, int level,
             Upsampling upsampling);
  [[nodiscard]] double work() override;

 private:
  const mres::gl::Texture2D& draw(const PeerFrame& frame) override;
  [[nodiscard]] std::vector<const mres::gl::RenderTarget*> targets() const override;

  LevelPicture coarse_;
  FilterPass filter_;
  UpsamplePass upsample_;
  LevelBlock block_;  // of the full resolution
  mres::gl::RenderTarget result_;
};

}  // namespace host
