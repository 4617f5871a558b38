#include "mres/level/effect_program.h"

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "mres/mask/zone_pass.h"

namespace mres {
namespace {

constexpr std::array<const char*, kMaxLevels> kScopeNames = {"mres.level0", "mres.level1", "mres.level2",
                                                             "mres.level3"};

}  // namespace

gl::Program makeEffectProgram(const gl::ShaderLibrary& library, const EffectDescription& effect,
                              const char* fragment) {
  gl::ShaderLibrary extended = library;
  extended.add(effect.shaders);
  extended.add("effect", "#include \"" + std::string(effect.shader) + "\"\n");
  return makePassProgram(extended, fragment,
                         "#define EFFECT_CHANNELS " + std::to_string(effect.channels) + "\n");
}

EffectProgram::EffectProgram(const gl::ShaderLibrary& library, const EffectDescription& description,
                             const char* fragment)
    : description_(description), fragment_(fragment), program_(compile(library)) {}

gl::Program EffectProgram::compile(const gl::ShaderLibrary& library) const {
  return makeEffectProgram(library, effect(), fragment_);
}

void EffectProgram::expectSame(const Effect& other) const {
  if (description_.describes(other.description())) return;
  throw std::logic_error(std::string("Two different effects are named '") + effect().name +
                         "'; name them differently, or forget() the first one.");
}

void EffectProgram::replace(gl::Program program) {
  program_ = std::move(program);
  isSetUp_ = false;
}

void EffectProgram::setUp(Effect& effect) {
  glUseProgram(program_.id());
  if (!isSetUp_) effect.setUp(program_);
  isSetUp_ = true;
  const glm::vec4 background = effect.background();
  glUniform4fv(program_.uniformLocation("backgroundValue"), 1, &background.x);
}

void EffectProgram::draw(PassContext& context, const gl::RenderTarget& target, int level, bool zoned) const {
  const gl::Scope scope(context.profiler, kScopeNames.at(static_cast<std::size_t>(level)));
  target.bind();
  if (zoned) clearAndDrawInZone();
  glUseProgram(program_.id());
  context.triangle.draw();
  glDisable(GL_STENCIL_TEST);
}

}  // namespace mres
