#pragma once

#include "mres/effect.h"
#include "mres/gl/render_target.h"
#include "mres/gl/uniform_buffer.h"
#include "mres/plan/level_plan.h"
#include "shaders/mres/level_params.h"

namespace mres {

/// What one effect renders into at one level, made on first use and when the size changes.
class LevelTargets {
 public:
  /// Makes what is missing for `size`; `zoned` levels get a stencil.
  void ensure(const EffectDescription& effect, glm::ivec2 size, bool zoned);

  [[nodiscard]] const gl::RenderTarget& raw() const { return raw_; }  ///< value and filter depth
  [[nodiscard]] const gl::RenderTarget& filteredAlongX() const { return filteredAlongX_; }
  [[nodiscard]] const gl::RenderTarget& composed() const {
    return composed_;
  }  ///< the picture down to this level
  gl::UniformBuffer<params::LevelParams>& params() { return params_; }
  [[nodiscard]] std::size_t bytes() const;

  /// Fills every texture with `value`.
  void fill(float value) const;

 private:
  gl::UniformBuffer<params::LevelParams> params_;
  gl::StencilBuffer stencil_;
  gl::RenderTarget raw_;
  gl::RenderTarget filteredAlongX_;
  gl::RenderTarget composed_;
  bool zoned_ = false;
};

/// The block of a level whose coarser neighbour is `coarser` (null for the coarsest).
params::LevelParams levelParams(const PlannedLevel& level, const PlannedLevel* coarser, glm::ivec2 fullSize);

}  // namespace mres
