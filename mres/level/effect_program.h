#pragma once

#include "mres/effect.h"
#include "mres/gl/program.h"
#include "mres/gl/render_target.h"
#include "mres/level/owned_description.h"
#include "mres/level/pass_context.h"

namespace mres {

/// A full-screen program of `fragment`, which includes the effect's shader as "effect"; left in use.
gl::Program makeEffectProgram(const gl::ShaderLibrary& library, const EffectDescription& effect,
                              const char* fragment);

/// The program that runs an effect's shade(), and which effect it is of.
class EffectProgram {
 public:
  /// `fragment`, a string literal, includes mres/effect_texel.glsl.
  EffectProgram(const gl::ShaderLibrary& library, const EffectDescription& description,
                const char* fragment = "mres/effect_level.frag");

  [[nodiscard]] const EffectDescription& effect() const { return description_.get(); }

  /// Throws std::logic_error with a sentence if the effect is another one of the same name.
  void expectSame(const Effect& effect) const;

  /// Compiles the program anew; replace() then puts it in the place of the one in use.
  [[nodiscard]] gl::Program compile(const gl::ShaderLibrary& library) const;
  void replace(gl::Program program);

  /// Lets the effect set up a program that it has not seen yet, and takes the frame's background from it.
  void setUp(Effect& effect);

  /// Draws a level of the effect into the whole of `target`, or its stencilled zone. Needs the frame's and
  /// the level's blocks and the effect bound.
  void draw(PassContext& context, const gl::RenderTarget& target, int level, bool zoned) const;

 private:
  OwnedDescription description_;
  const char* fragment_;
  gl::Program program_;
  bool isSetUp_ = false;
};

}  // namespace mres
