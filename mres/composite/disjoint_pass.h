#pragma once

#include "mres/level/level_targets.h"
#include "mres/level/pass_context.h"

namespace mres {

/// Draws around the zones of levels that are disjoint (section 3.1 of the paper): each pixel is rendered by
/// the finest level whose zone it is in, and by no other.
class DisjointPass {
 public:
  explicit DisjointPass(const gl::ShaderLibrary& library);

  /// The coarsest level's zone is the whole screen.
  void startCoarsest(const LevelTargets& level);

  /// Like CompositePass::drawOutsideZone(), of the coarser picture where there is one.
  void drawOutsideZone(PassContext& context, const LevelTargets& level, const gl::Texture2D& zone,
                       const gl::Texture2D& coarser);

  /// Takes what the zone of a finer level covers from the zone of `level`.
  void takeFiner(PassContext& context, const LevelTargets& level, const gl::Texture2D& finerZone,
                 int finerLevel);

 private:
  gl::Program outside_;
  gl::Program covered_;
};

}  // namespace mres
