#pragma once

#include "mres/effect.h"
#include "mres/gl/program.h"

namespace mres {

/// A full-screen program of `fragment`, which includes the effect's shader as "effect"; left in use.
gl::Program makeEffectProgram(const gl::ShaderLibrary& library, const EffectDescription& effect,
                              const char* fragment);

}  // namespace mres
