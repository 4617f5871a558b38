#include "mres/level/coverage.h"

namespace mres {

void CoverageQueries::collect(Level& level) {
  if (!level.pending) return;
  GLuint available = GL_FALSE;
  glGetQueryObjectuiv(level.query.id(), GL_QUERY_RESULT_AVAILABLE, &available);
  if (available != GL_TRUE) return;
  GLuint samples = 0;
  glGetQueryObjectuiv(level.query.id(), GL_QUERY_RESULT, &samples);
  level.coverage = samples / level.pixels;
  level.pending = false;
}

void CoverageQueries::beginFrame(const LevelPlan& plan) {
  for (Level& level : levels_) collect(level);
  for (const PlannedLevel& planned : plan.levels) {
    Level& level = levels_.at(static_cast<std::size_t>(planned.index));
    level.pixels = static_cast<double>(planned.size.x) * planned.size.y;
  }
}

void CoverageQueries::beginLevel(int index) {
  Level& level = levels_.at(static_cast<std::size_t>(index));
  if (!level.query) level.query = gl::QueryName::create();
  glBeginQuery(GL_SAMPLES_PASSED, level.query.id());
  level.pending = true;
}

void CoverageQueries::endLevel() {
  glEndQuery(GL_SAMPLES_PASSED);
}

double CoverageQueries::of(int index) {
  Level& level = levels_.at(static_cast<std::size_t>(index));
  collect(level);
  return level.coverage;
}

}  // namespace mres
