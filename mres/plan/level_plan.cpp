#include "mres/plan/level_plan.h"

#include <algorithm>
#include <array>

namespace mres {
namespace {

/// Below this a level is all zone and border: its passes cost more than they save.
constexpr int kSmallestLevel = 8;

constexpr std::array<const char*, kMaxLevels> kLevelNames = {"level0", "level1", "level2", "level3"};

}  // namespace

glm::ivec2 levelSize(glm::ivec2 fullSize, int level) {
  const int stride = 1 << level;
  return (fullSize + stride - 1) / stride;
}

LevelPlan planLevels(Technique technique, const LevelTable& table, glm::ivec2 fullSize, bool fallsBack) {
  LevelPlan plan;
  for (int index = 0; index < kMaxLevels; ++index) {
    const auto slot = static_cast<std::size_t>(index);
    const glm::ivec2 size = levelSize(fullSize, index);
    const char* reason = nullptr;
    if (technique == Technique::full) {
      reason = index == 0 ? nullptr : "the full technique renders level 0 alone";
    } else if (index > 0 && fallsBack) {
      reason = "the plain effect is faster here";
    } else if (index > 0 && !table.at(slot).used) {
      reason = "not used by this effect";
    } else if (index > 0 && std::min(size.x, size.y) < kSmallestLevel) {
      reason = "too small to pay for its passes";
    }
    if (reason == nullptr) {
      plan.levels.push_back({index, size, table.at(slot)});
    } else {
      plan.skipped.push_back({kLevelNames.at(slot), reason});
    }
  }
  return plan;
}

}  // namespace mres
