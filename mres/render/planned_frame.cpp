#include "mres/render/planned_frame.h"

namespace mres {

LevelRole PlannedFrame::roleOf(std::size_t planned) const {
  if (isDisjoint()) return LevelRole::zoned;
  if (isCoarsest(planned)) return LevelRole::coarsest;
  return planned == 1 ? LevelRole::refinable : LevelRole::zoned;
}

bool PlannedFrame::isProgressive(std::size_t planned) const {
  return settings.mask.refineThreshold > 0.0f && planned == 0 && !isCoarsest(planned) &&
         roleOf(1) == LevelRole::refinable;
}

ZoneInputs PlannedFrame::zoneInputs(std::size_t planned) const {
  const LevelTargets& coarser = targets(planned + 1);
  return {.mask = &shared.masks.mask(level(planned).index),
          .coarser = &coarser.composed().color(0),
          .refine = isProgressive(planned) ? &coarser.composed().color(1) : nullptr};
}

void PlannedFrame::prepareLevels() const {
  const glm::ivec2 fullSize = level(0).size;
  for (std::size_t i = 0; i < plan.levels.size(); ++i) {
    const LevelNeighbours neighbours{level(i), isCoarsest(i) ? nullptr : &level(i + 1), isProgressive(i)};
    targets(i).ensure(passes.effect.effect(), level(i).size, roleOf(i));
    targets(i).params().upload(levelParams(neighbours, fullSize, settings.mask.refineThreshold));
  }
}

}  // namespace mres
