#pragma once

#include "mres/level/level_targets.h"
#include "mres/level/pass_context.h"

namespace mres {

/// Filters a level and blends it over the coarser one (equation 1 of the paper), for one kind of effect.
class CompositePass {
 public:
  CompositePass(const gl::ShaderLibrary& library, const EffectDescription& effect);

  /// The coarsest level: filtered, nothing below it.
  void drawCoarsest(PassContext& context, LevelTargets& level);

  /// A finer level: the upsampled coarser picture outside of the zone, the blend inside. Needs the frame's
  /// and the level's blocks bound, depth and normals too where the effect is filtered.
  void draw(PassContext& context, LevelTargets& level, const ZoneInputs& zone);

 private:
  const gl::Texture2D& filterAlongX(PassContext& context, LevelTargets& level, bool zoned);

  bool filtered_;
  gl::Program filter_;
  gl::Program coarsest_;
  /// Programs of a zoned level, by whether a finer one follows (then they also write where to refine).
  struct ZonePrograms {
    gl::Program blend;
    gl::Program blendProgressively;
    gl::Program upsample;
  };
  static ZonePrograms makeZonePrograms(const gl::ShaderLibrary& library, const EffectDescription& effect,
                                       LevelRole role);
  ZonePrograms finest_;
  ZonePrograms intermediate_;
};

}  // namespace mres
