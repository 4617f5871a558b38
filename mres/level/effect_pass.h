#pragma once

#include <array>
#include <utility>

#include "mres/effect.h"
#include "mres/level/effect_program.h"
#include "mres/level/level_targets.h"
#include "mres/level/pass_context.h"

namespace mres {

/// One effect: its program and its targets at every level.
class EffectPass {
 public:
  EffectPass(const gl::ShaderLibrary& library, const EffectDescription& description)
      : program_(library, description) {}

  [[nodiscard]] const EffectDescription& effect() const { return program_.effect(); }

  /// As EffectProgram has them; setProgram() keeps the targets.
  void expectSame(const Effect& effect) const { program_.expectSame(effect); }
  [[nodiscard]] gl::Program compile(const gl::ShaderLibrary& library) const {
    return program_.compile(library);
  }
  void setProgram(gl::Program program) { program_.replace(std::move(program)); }
  void setUp(Effect& effect) { program_.setUp(effect); }

  /// Draws the effect into the raw target of `level`: the whole of it, or its stencilled zone. Needs the
  /// frame's and level's blocks and the effect bound.
  void draw(PassContext& context, int level, bool zoned) {
    program_.draw(context, targets(level).raw(), level, zoned);
  }

  LevelTargets& targets(int level) { return targets_.at(static_cast<std::size_t>(level)); }
  [[nodiscard]] std::size_t bytes() const;
  void fillTargets(float value) const;

 private:
  EffectProgram program_;
  std::array<LevelTargets, kMaxLevels> targets_;
};

}  // namespace mres
