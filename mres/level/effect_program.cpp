#include "mres/level/effect_program.h"

#include <string>

#include "mres/level/pass_context.h"

namespace mres {

gl::Program makeEffectProgram(const gl::ShaderLibrary& library, const EffectDescription& effect,
                              const char* fragment) {
  gl::ShaderLibrary extended = library;
  extended.add(effect.shaders);
  extended.add("effect", "#include \"" + std::string(effect.shader) + "\"\n");
  return makePassProgram(extended, fragment,
                         "#define EFFECT_CHANNELS " + std::to_string(effect.channels) + "\n");
}

}  // namespace mres
