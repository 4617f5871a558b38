#include "mres/render/planned_frame.h"

namespace mres {

LevelRole PlannedFrame::roleOf(std::size_t planned) const {
  if (isDisjoint()) return LevelRole::zoned;
  if (isCoarsest(planned)) return LevelRole::coarsest;
  return planned == 0 ? LevelRole::zoned : LevelRole::intermediate;
}

ZoneInputs PlannedFrame::zoneInputs(std::size_t planned) const {
  const LevelTargets& coarser = targets(planned + 1);
  const bool progressive = settings.mask.refineThreshold > 0.0f && coarser.role() == LevelRole::intermediate;
  return {.mask = &shared.masks.mask(level(planned).index),
          .coarser = &coarser.composed().color(0),
          .refine = progressive ? &coarser.composed().color(1) : nullptr};
}

void PlannedFrame::prepareLevels() const {
  const glm::ivec2 fullSize = level(0).size;
  for (std::size_t i = 0; i < plan.levels.size(); ++i) {
    const LevelNeighbours neighbours{level(i), isCoarsest(i) ? nullptr : &level(i + 1),
                                     i == 0 ? nullptr : &level(i - 1)};
    targets(i).ensure(passes.effect.effect(), level(i).size, roleOf(i));
    targets(i).params().upload(levelParams(neighbours, fullSize, settings.mask.refineThreshold));
  }
}

}  // namespace mres
