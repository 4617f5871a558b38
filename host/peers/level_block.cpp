#include "host/peers/level_block.h"

#include "mres/level/level_targets.h"

namespace host {
namespace {

constexpr float kNoThreshold = 0.0f;  // what mres refines by

}  // namespace

void LevelBlock::bind(const PeerFrame& frame, int level, std::optional<int> coarser) {
  const mres::PlannedLevel planned = frame.level(level);
  const mres::PlannedLevel below = frame.level(coarser.value_or(level));
  block_.upload(mres::levelParams({planned, coarser ? &below : nullptr, frame.description().filtered},
                                  frame.size, kNoThreshold));
  block_.bind(mres::kLevelBlock);
}

}  // namespace host
