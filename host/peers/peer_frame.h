#pragma once

#include <glm/glm.hpp>

#include "mres/effect.h"
#include "mres/gl/program.h"
#include "mres/gl/render_target.h"
#include "mres/level/depth_pyramid.h"
#include "mres/level/effect_program.h"
#include "mres/level/pass_context.h"
#include "mres/plan/level_plan.h"

namespace host {

/// A frame that is set up: its textures, its block and what the effect reads are bound.
struct PeerFrame {
  [[nodiscard]] const mres::EffectDescription& description() const { return effect.effect(); }
  /// Of the effect's table, whether the effect uses it or not.
  [[nodiscard]] mres::PlannedLevel level(int index) const;

  /// Draws a level of the effect into the whole of `target`, or its stencilled zone. Needs the level's block
  /// bound.
  void drawEffect(const mres::gl::RenderTarget& target, int level, bool zoned = false) const;

  /// Puts a program to use that may ask for the value of the background.
  void use(const mres::gl::Program& program) const;

  mres::PassContext& context;
  const mres::EffectProgram& effect;
  const mres::DepthPyramid& pyramid;
  const mres::LevelTable& levels;
  glm::ivec2 size{0};
  glm::vec4 background{0.0f};
};

/// Makes a target anew unless it has that size.
void ensure(mres::gl::RenderTarget& target, glm::ivec2 size, GLenum format, const char* label);

/// How many pixels some are of all.
double pixelShare(glm::ivec2 some, glm::ivec2 all);

}  // namespace host
