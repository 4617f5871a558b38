#pragma once

#include "mres/gl/render_target.h"
#include "mres/level/level_targets.h"
#include "mres/level/pass_context.h"

namespace mres {

/// The stencil value of a level's zone; elsewhere it is 0.
inline constexpr GLint kZone = 1;

/// Writes kZone where a level renders: where its mask is above zero (section 4.1 of the paper) and, where the
/// coarser level has a say, refining makes a difference (the progressive decomposition of section 6).
class StencilPass {
 public:
  explicit StencilPass(const gl::ShaderLibrary& library);

  /// Clears the stencil of `target`, then marks the zone. Needs the frame's and the level's blocks bound.
  void draw(PassContext& context, const gl::RenderTarget& target, const ZoneInputs& zone);

 private:
  gl::Program byMask_;
  gl::Program byMaskAndRefinement_;
};

/// Draws pass only where the stencil says so, and leave it as it is.
void testStencil(GLenum function);

}  // namespace mres
