#include "mres/plan/frame_cost.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace mres {
namespace {

constexpr std::array<std::string_view, 2> kShared = {"mres.depth", "mres.inputs"};
constexpr std::array<std::string_view, 6> kEvaluation = {"mres.level0", "mres.level1", "mres.level2",
                                                         "mres.level3", "mres.filter", "mres.composite"};

}  // namespace

FrameCost frameCost(const std::vector<gl::StageTime>& stages) {
  FrameCost cost;
  for (const gl::StageTime& stage : stages) {
    if (std::ranges::find(kShared, stage.name) != kShared.end()) {
      cost.sharedMs += stage.milliseconds;
    } else if (std::ranges::find(kEvaluation, stage.name) != kEvaluation.end()) {
      cost.evaluationMs += stage.milliseconds;
    } else {
      cost.overheadMs += stage.milliseconds;
      cost.byLevels = true;
    }
  }
  return cost;
}

}  // namespace mres
