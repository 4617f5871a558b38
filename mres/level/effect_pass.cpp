#include "mres/level/effect_pass.h"

namespace mres {

std::size_t EffectPass::bytes() const {
  std::size_t sum = 0;
  for (const LevelTargets& targets : targets_) sum += targets.bytes();
  return sum;
}

void EffectPass::fillTargets(float value) const {
  for (const LevelTargets& targets : targets_) targets.fill(value);
}

}  // namespace mres
