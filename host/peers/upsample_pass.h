#pragma once

#include "host/peers/peer_frame.h"

namespace host {

enum class Upsampling {
  bilinear,
  joint  ///< by depth and normal
};

/// Draws a coarser level's picture at a finer level.
class UpsamplePass {
 public:
  UpsamplePass(const mres::gl::ShaderLibrary& library, const mres::EffectDescription& effect,
               Upsampling upsampling);

  /// Into the whole of the target or outside of its stencilled zone. Needs the finer level's block bound,
  /// with its coarser one.
  void draw(const PeerFrame& frame, const mres::gl::Texture2D& coarser, const mres::gl::RenderTarget& target,
            bool outsideZone = false) const;

 private:
  mres::gl::Program program_;
};

}  // namespace host
