#pragma once

#include "mres/level/level_targets.h"
#include "mres/level/pass_context.h"

namespace mres {

/// Filters a level and blends it over the coarser one, for one kind of effect.
class CompositePass {
 public:
  CompositePass(const gl::ShaderLibrary& library, const EffectDescription& effect);

  /// A level with nothing below it: filtered; in its zone where it has one. Needs what drawZone() needs.
  void drawAlone(PassContext& context, const LevelTargets& level);

  /// A finer level, before its effect is drawn: the coarser picture outside of the zone, and a stencil of the
  /// zone. Needs the frame's and the level's blocks bound.
  void drawOutsideZone(PassContext& context, const LevelTargets& level, const ZoneInputs& inputs,
                       const gl::Texture2D& zone);

  /// After the effect is drawn: the blend inside of the zone. Needs depth and normals bound too where the
  /// effect is filtered.
  void drawZone(PassContext& context, const LevelTargets& level, const ZoneInputs& inputs,
                const gl::Texture2D& zone);

 private:
  const gl::Texture2D& filterAlongX(PassContext& context, const LevelTargets& level);

  bool filtered_;
  gl::Program filter_;
  gl::Program alone_;
  /// Programs of a level that has a zone, by its role.
  struct ZonePrograms {
    gl::Program blend;
    gl::Program outside;
  };
  static ZonePrograms makeZonePrograms(const gl::ShaderLibrary& library, const EffectDescription& effect,
                                       LevelRole role);
  [[nodiscard]] const ZonePrograms& programsOf(const LevelTargets& level) const;

  ZonePrograms masked_;
  ZonePrograms zoned_;
  ZonePrograms refinable_;
};

}  // namespace mres
