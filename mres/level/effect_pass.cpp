#include "mres/level/effect_pass.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "mres/level/effect_program.h"
#include "mres/mask/zone_pass.h"

namespace mres {
namespace {

constexpr std::array<const char*, kMaxLevels> kScopeNames = {"mres.level0", "mres.level1", "mres.level2",
                                                             "mres.level3"};

}  // namespace

EffectPass::EffectPass(const gl::ShaderLibrary& library, const EffectDescription& description)
    : description_(description), program_(compile(library)) {}

gl::Program EffectPass::compile(const gl::ShaderLibrary& library) const {
  return makeEffectProgram(library, effect(), "mres/effect_level.frag");
}

void EffectPass::expectSame(const Effect& other) const {
  if (description_.describes(other.description())) return;
  throw std::logic_error(std::string("Two different effects are named '") + effect().name +
                         "'; name them differently, or forget() the first one.");
}

void EffectPass::setProgram(gl::Program program) {
  program_ = std::move(program);
  isSetUp_ = false;
}

void EffectPass::setUp(Effect& effect) {
  glUseProgram(program_.id());
  if (!isSetUp_) effect.setUp(program_);
  isSetUp_ = true;
  const glm::vec4 background = effect.background();
  glUniform4fv(program_.uniformLocation("backgroundValue"), 1, &background.x);
}

void EffectPass::draw(PassContext& context, int level, bool zoned) {
  const gl::Scope scope(context.profiler, kScopeNames.at(static_cast<std::size_t>(level)));
  targets(level).raw().bind();
  if (zoned) {
    // Filter depth 0 marks what was not rendered, so that the filter never reads it.
    constexpr std::array<float, 4> kUndefined{};
    glClearBufferfv(GL_COLOR, 0, kUndefined.data());
    drawInZone();
  }
  glUseProgram(program_.id());
  context.triangle.draw();
  glDisable(GL_STENCIL_TEST);
}

std::size_t EffectPass::bytes() const {
  std::size_t sum = 0;
  for (const LevelTargets& targets : targets_) sum += targets.bytes();
  return sum;
}

void EffectPass::fillTargets(float value) const {
  for (const LevelTargets& targets : targets_) targets.fill(value);
}

}  // namespace mres
