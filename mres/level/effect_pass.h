#pragma once

#include <array>
#include <vector>

#include "mres/effect.h"
#include "mres/level/level_targets.h"
#include "mres/level/owned_description.h"
#include "mres/level/pass_context.h"

namespace mres {

/// One effect: its program and its targets at every level.
class EffectPass {
 public:
  EffectPass(const gl::ShaderLibrary& library, const EffectDescription& description);

  [[nodiscard]] const EffectDescription& effect() const { return description_.get(); }

  /// Throws std::logic_error with a sentence if the effect is another one of the same name.
  void expectSame(const Effect& effect) const;

  /// Compiles the program anew; setProgram() then replaces the one in use and keeps the targets.
  [[nodiscard]] gl::Program compile(const gl::ShaderLibrary& library) const;
  void setProgram(gl::Program program);

  /// Lets the effect set up a program that it has not seen yet, and takes the frame's background from it.
  void setUp(Effect& effect);

  /// Draws the effect into the raw target of `level`: the whole of it, or its stencilled zone. Needs the
  /// frame's and level's blocks and the effect bound.
  void draw(PassContext& context, int level, bool zoned);

  LevelTargets& targets(int level) { return targets_.at(static_cast<std::size_t>(level)); }
  [[nodiscard]] std::size_t bytes() const;
  void fillTargets(float value) const;

 private:
  OwnedDescription description_;
  gl::Program program_;
  bool isSetUp_ = false;
  std::array<LevelTargets, kMaxLevels> targets_;
};

}  // namespace mres
