#include "mres/render/planned_frame.h"

namespace mres {

float PlannedFrame::refineThreshold() const {
  return settings.mask.errorBudget * MaskSettings::kDifferencePerError;
}

LevelRole PlannedFrame::roleOf(std::size_t planned) const {
  if (isDisjoint()) return LevelRole::zoned;
  if (isCoarsest(planned)) return LevelRole::coarsest;
  if (isByMasks()) return LevelRole::masked;
  return planned > 0 && settings.mask.errorBudget > 0.0f ? LevelRole::refinable : LevelRole::zoned;
}

ZoneRule PlannedFrame::zoneRuleOf(std::size_t planned) const {
  if (isByMasks()) return ZoneRule::mask;
  if (isDisjoint() || settings.mask.errorBudget == 0.0f) return ZoneRule::edges;
  if (roleOf(planned + 1) == LevelRole::coarsest) return ZoneRule::edgesOrBends;
  if (planned == 0) return ZoneRule::difference;
  // An effect's own edges are where it varies, and min/max mips don't tell normals from depth.
  const bool shows = passes.effect.effect().hasPreview || settings.mask.minMaxMips;
  return shows ? ZoneRule::edgesOrDifference : ZoneRule::shownEdgesOrDifference;
}

ZoneInputs PlannedFrame::zoneInputs(std::size_t planned) const {
  const LevelTargets& coarser = targets(planned + 1);
  const int index = level(planned).index;
  return {.rule = zoneRuleOf(planned),
          .channels = passes.effect.effect().channels,
          .mask = isByMasks() ? &shared.masks.blurred(index) : &shared.masks.edges(index),
          .coarser = &coarser.composed().color(0),
          .refine = coarser.role() == LevelRole::refinable ? &coarser.composed().color(1) : nullptr};
}

void PlannedFrame::prepareLevels() const {
  const glm::ivec2 fullSize = level(0).size;
  for (std::size_t i = 0; i < plan.levels.size(); ++i) {
    const LevelNeighbours neighbours{level(i), isCoarsest(i) ? nullptr : &level(i + 1),
                                     passes.effect.effect().filtered};
    targets(i).ensure(passes.effect.effect(), level(i).size, roleOf(i));
    targets(i).params().upload(levelParams(neighbours, fullSize, refineThreshold()));
  }
}

}  // namespace mres
