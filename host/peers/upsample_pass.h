#pragma once

#include "host/peers/peer_frame.h"

namespace host {

enum class Upsampling {
  bilinear,
  joint,            ///< by depth and normal
  jointAroundTiles  ///< the same outside of the level's tiles, which become the target's stencilled zone
};

/// Draws a coarser level's picture at a finer level.
class UpsamplePass {
 public:
  UpsamplePass(const mres::gl::ShaderLibrary& library, const mres::EffectDescription& effect,
               Upsampling upsampling);

  /// Needs the finer level's block bound, with its coarser one; around tiles, the rates too (kZoneUnit).
  void draw(const PeerFrame& frame, const mres::gl::Texture2D& coarser,
            const mres::gl::RenderTarget& target) const;

 private:
  Upsampling upsampling_;
  mres::gl::Program program_;
};

}  // namespace host
