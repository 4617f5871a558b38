// The fixed-function state of a pass, set as a whole, so that no pass inherits anything from the one before.
#pragma once

#include <epoxy/gl.h>

namespace host {

struct RenderState {
  enum class Cull { none, back, front };
  enum class Depth { off, test, testAndWrite };
  enum class Blend { off, over };

  Depth depth = Depth::off;
  Cull cull = Cull::none;
  Blend blend = Blend::off;
  bool encodeSrgb = false;         ///< on writes to sRGB targets
  float slopeScaledOffset = 0.0f;  ///< of depth, in slopes
  float constantOffset = 0.0f;     ///< of depth, in the format's smallest steps
};

/// Sets the state; scissor, stencil and the like are off, all channels are written, front faces are
/// counter-clockwise.
void apply(const RenderState& state);

/// Sets face culling alone, for materials that differ in it.
void apply(RenderState::Cull cull);

/// Instances with a negative determinant turn their triangles around.
void setMirrored(bool mirrored);

}  // namespace host
