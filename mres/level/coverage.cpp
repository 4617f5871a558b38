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
  level.known = true;
  level.pending = false;
}

// Beginning a query anew throws its result away: where results take several frames, there would never be one.
void CoverageQueries::begin(const PlannedLevel& planned) {
  Level& level = levels_.at(static_cast<std::size_t>(planned.index));
  collect(level);
  if (level.pending) return;
  if (!level.query) level.query = gl::QueryName::create();
  level.pixels = static_cast<double>(planned.size.x) * planned.size.y;
  glBeginQuery(GL_SAMPLES_PASSED, level.query.id());
  level.pending = true;
  counting_ = true;
}

void CoverageQueries::end() {
  if (counting_) glEndQuery(GL_SAMPLES_PASSED);
  counting_ = false;
}

CoverageQueries::Level& CoverageQueries::collected(int index) {
  Level& level = levels_.at(static_cast<std::size_t>(index));
  collect(level);
  return level;
}

double CoverageQueries::of(int index) {
  return collected(index).coverage;
}

bool CoverageQueries::isKnown(int index) {
  return collected(index).known;
}

}  // namespace mres
