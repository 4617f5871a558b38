#pragma once

#include "host/peers/peer_frame.h"

namespace host {

/// The effect's filter, an axis at a time. Both need the level's block bound, and draw into the whole of the
/// target or its stencilled zone.
class FilterPass {
 public:
  FilterPass(const mres::gl::ShaderLibrary& library, const mres::EffectDescription& effect);

  /// For filtered effects alone.
  void alongX(const PeerFrame& frame, const mres::gl::Texture2D& source, const mres::gl::RenderTarget& target,
              bool zoned = false) const;

  /// After alongX(). Copies unfiltered effects. The target may lack the filter depth.
  void alongY(const PeerFrame& frame, const mres::gl::Texture2D& source, const mres::gl::RenderTarget& target,
              bool zoned = false) const;

 private:
  mres::gl::Program alongX_;
  mres::gl::Program alongY_;
};

}  // namespace host
