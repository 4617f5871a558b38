#pragma once

#include "mres/effect.h"
#include "mres/gl/render_target.h"
#include "mres/gl/uniform_buffer.h"
#include "mres/plan/level_plan.h"
#include "shaders/mres/level_params.h"

namespace mres {

/// Of an effect's values with their filter depth.
GLenum levelFormat(const EffectDescription& effect);

/// Of an effect's values alone.
GLenum resultFormat(const EffectDescription& effect);

/// A level's place among those that a frame renders. A frame of one level has the coarsest alone.
enum class LevelRole {
  zoned,      ///< renders in its zone
  refinable,  ///< renders in its zone, and says where it differs from the coarser level
  masked,     ///< renders in its zone, and is blended by its mask
  coarsest    ///< renders the whole screen
};

/// What one effect renders into at one level, made on first use and when the size changes.
class LevelTargets {
 public:
  /// Makes what is missing for `size`: all or, if the driver rejects a target, nothing.
  void ensure(const EffectDescription& effect, glm::ivec2 size, LevelRole role);

  /// Gives the picture `value` at every pixel, and makes nothing else for that.
  void fillAlone(const EffectDescription& effect, glm::ivec2 size, glm::vec4 value);

  [[nodiscard]] const gl::RenderTarget& raw() const { return targets_.raw; }  ///< value and filter depth
  [[nodiscard]] const gl::RenderTarget& filteredAlongX() const { return targets_.filteredAlongX; }
  [[nodiscard]] const gl::RenderTarget& composed() const {
    return targets_.composed;
  }  ///< the picture down to this level
  [[nodiscard]] LevelRole role() const { return role_; }
  gl::UniformBuffer<params::LevelParams>& params() { return params_; }
  [[nodiscard]] std::size_t bytes() const;

  /// Fills every texture with `value`.
  void fill(float value) const;

 private:
  struct Targets {
    gl::StencilBuffer stencil;
    gl::RenderTarget raw;
    gl::RenderTarget filteredAlongX;
    gl::RenderTarget composed;
  };
  static Targets make(const EffectDescription& effect, glm::ivec2 size, LevelRole role);
  [[nodiscard]] bool serves(LevelRole role) const;

  gl::UniformBuffer<params::LevelParams> params_;
  Targets targets_;
  LevelRole madeFor_ = LevelRole::coarsest;
  LevelRole role_ = LevelRole::coarsest;
};

/// What says that a level renders somewhere.
enum class ZoneRule {
  mask,               ///< its blurred mask
  edges,              ///< its edges
  edgesOrBends,       ///< its edges, and where the coarser level, the coarsest, bends
  edgesOrDifference,  ///< its edges, and where the coarser level differed from what is coarser still
  /// As edgesOrDifference, but edges of normals count only where the coarser level's picture varies, or where
  /// some of what is seen there faces as nothing does that the coarser level rendered.
  shownEdgesOrDifference,
  difference  ///< where the coarser level differed alone
};

/// What a level that does not render the whole screen is made from.
struct ZoneInputs {
  ZoneRule rule = ZoneRule::edges;
  int channels = 1;                        ///< of the effect
  const gl::Texture2D* mask = nullptr;     ///< of this level: blurred, or edges
  const gl::Texture2D* coarser = nullptr;  ///< the picture down to the coarser level
  const gl::Texture2D* refine = nullptr;   ///< where the coarser level saw a difference, if it is refinable
};

/// A level among those that a frame renders.
struct LevelNeighbours {
  const PlannedLevel& level;
  const PlannedLevel* coarser = nullptr;  ///< null: there is none
  bool filtered = true;                   ///< EffectDescription::filtered
};

/// The block of a level.
params::LevelParams levelParams(const LevelNeighbours& level, glm::ivec2 fullSize, float refineThreshold);

}  // namespace mres
