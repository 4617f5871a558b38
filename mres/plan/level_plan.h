#pragma once

#include <glm/glm.hpp>

#include "mres/effect.h"
#include "mres/plan/per_level.h"
#include "mres/report.h"
#include "mres/settings.h"

namespace mres {

/// A level that a frame renders.
struct PlannedLevel {
  int index = 0;  ///< 0 full, 1 half, 2 quarter, 3 eighth
  glm::ivec2 size{0};
  LevelSettings settings;
};

/// Which levels a frame renders, finest first; the last covers the whole screen.
struct LevelPlan {
  PerLevel<PlannedLevel> levels;
  PerLevel<Skip> skipped;
};

/// ceil(size / 2^level).
glm::ivec2 levelSize(glm::ivec2 fullSize, int level);

/// Chooses the levels: level 0, which the result has the size of, and the coarser ones that the effect uses
/// and that are large enough to be worth a pass. Technique::full, or a screen too small for a second level,
/// gives level 0 alone.
///
/// `fallsBack`: the plain effect stands in for levels, as it is faster.
LevelPlan planLevels(Technique technique, const LevelTable& table, glm::ivec2 fullSize,
                     bool fallsBack = false);

}  // namespace mres
