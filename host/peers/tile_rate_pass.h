#pragma once

#include "host/peers/peer_frame.h"

namespace host {

/// Chooses the level that renders each tile of ADAPTIVE_TILE x ADAPTIVE_TILE pixels, from the picture of the
/// quarter level (shaders/peers/tile_rates.frag).
class TileRatePass {
 public:
  TileRatePass(const mres::gl::ShaderLibrary& library, const mres::EffectDescription& effect);

  /// Needs the quarter level's block bound. A larger threshold makes coarser tiles.
  void draw(const PeerFrame& frame, const mres::gl::Texture2D& quarter, float threshold);

  /// Makes the tiles of the level whose block is bound the target's stencilled zone.
  void startZone(const PeerFrame& frame, const mres::gl::RenderTarget& target) const;

  /// GL_R8, a texel a tile: as shaders/peers/tile_rate.glsl reads it.
  [[nodiscard]] const mres::gl::RenderTarget& rates() const { return rates_; }

 private:
  mres::gl::Program program_;
  mres::gl::Program outside_;
  mres::gl::RenderTarget rates_;
};

}  // namespace host
