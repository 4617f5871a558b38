#include "mres/render/draw_levels.h"

namespace mres {
namespace {

void drawEffect(const PlannedFrame& planned, std::size_t level) {
  EffectPasses& passes = planned.passes;
  if (passes.effect.effect().readsPyramid)
    gl::bindTexture(kSourceUnit, planned.shared.pyramid.texture().id(), planned.context.nearestMip);
  if (planned.measureCoverage) passes.coverage.begin(planned.level(level));
  passes.effect.draw(planned.context, planned.level(level).index,
                     planned.roleOf(level) != LevelRole::coarsest);
  if (planned.measureCoverage) passes.coverage.end();
}

void drawZone(const PlannedFrame& planned, std::size_t level) {
  const ZoneInputs inputs = planned.zoneInputs(level);
  if (inputs.rule == ZoneRule::shownEdgesOrDifference) planned.shared.edges.bindParams();
  planned.shared.zones.draw(planned.context, planned.level(level), inputs);
}

void drawCoarsestLevel(const PlannedFrame& planned, std::size_t level) {
  drawEffect(planned, level);
  planned.passes.composite.drawAlone(planned.context, planned.targets(level));
}

void drawFinerLevel(const PlannedFrame& planned, std::size_t level) {
  const LevelTargets& targets = planned.targets(level);
  const ZoneInputs inputs = planned.zoneInputs(level);
  drawZone(planned, level);
  planned.passes.composite.drawOutsideZone(planned.context, targets, inputs, planned.zone(level));
  drawEffect(planned, level);
  planned.passes.composite.drawZone(planned.context, targets, inputs, planned.zone(level));
}

void drawBlendedLevels(const PlannedFrame& planned) {
  for (std::size_t i = planned.plan.levels.size(); i-- > 0;) {
    planned.targets(i).params().bind(kLevelBlock);
    if (planned.isCoarsest(i))
      drawCoarsestLevel(planned, i);
    else
      drawFinerLevel(planned, i);
  }
}

// A level leaves out what the finer ones render.
void startDisjointLevel(const PlannedFrame& planned, std::size_t level) {
  const LevelTargets& targets = planned.targets(level);
  DisjointPass& disjoint = planned.shared.disjoint;
  if (planned.isCoarsest(level))
    disjoint.startCoarsest(targets);
  else
    disjoint.drawOutsideZone(planned.context, targets, planned.zone(level),
                             planned.targets(level + 1).composed().color());
  if (level > 0)
    disjoint.takeFiner(planned.context, targets, planned.zone(level - 1), planned.level(level - 1).index);
}

void drawDisjointLevels(const PlannedFrame& planned) {
  for (std::size_t i = 0; !planned.isCoarsest(i); ++i) {
    planned.targets(i).params().bind(kLevelBlock);
    drawZone(planned, i);
  }
  for (std::size_t i = planned.plan.levels.size(); i-- > 0;) {
    planned.targets(i).params().bind(kLevelBlock);
    startDisjointLevel(planned, i);
    drawEffect(planned, i);
    planned.passes.composite.drawAlone(planned.context, planned.targets(i));
  }
}

}  // namespace

void drawLevels(const PlannedFrame& planned) {
  if (planned.isDisjoint())
    drawDisjointLevels(planned);
  else
    drawBlendedLevels(planned);
}

}  // namespace mres
