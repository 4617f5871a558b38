#pragma once

#include "host/peers/level_picture.h"
#include "host/peers/peer_base.h"
#include "host/peers/tile_rate_pass.h"
#include "host/peers/tiled_level.h"
#include "host/peers/upsample_pass.h"
#include "mres/level/coverage.h"

namespace host {

/// A content-adaptive shading rate: tiles at full, half or quarter resolution, as far as the picture of the
/// quarter level says that they need it, each upsampled by depth and normal.
class AdaptiveTilesPeer final : public PeerBase {
 public:
  AdaptiveTilesPeer(const mres::EffectDescription& effect, const PeerOptions& options);
  [[nodiscard]] double work() override;
  [[nodiscard]] std::size_t bytes() const override;

 private:
  const mres::gl::Texture2D& draw(const PeerFrame& frame) override;
  [[nodiscard]] std::vector<const mres::gl::RenderTarget*> targets() const override;
  void drawTiles(const PeerFrame& frame, TiledLevel& level, const mres::gl::Texture2D& coarser);
  void drawEffect(const PeerFrame& frame, const TiledLevel& level);

  float threshold_;
  bool measureWork_;
  FilterPass filter_;
  TileRatePass rates_;
  UpsamplePass aroundTiles_;
  LevelPicture quarter_{2};
  TiledLevel half_{1};
  TiledLevel full_{0};
  mres::CoverageQueries coverage_;
};

}  // namespace host
