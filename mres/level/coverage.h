#pragma once

#include <array>

#include "mres/gl/object.h"
#include "mres/plan/level_plan.h"

namespace mres {

/// Counts the pixels in which one effect ran, by occlusion queries that are read when they are ready.
class CoverageQueries {
 public:
  /// Counts what is drawn until end(), unless the level's last count is still under way.
  void begin(const PlannedLevel& level);
  void end();

  /// Share of the level's pixels, as of the latest frame known; 1 while none is.
  [[nodiscard]] double of(int level);
  [[nodiscard]] bool isKnown(int level);

 private:
  struct Level {
    gl::QueryName query;
    double pixels = 0.0;
    double coverage = 1.0;
    bool known = false;
    bool pending = false;
  };
  static void collect(Level& level);
  Level& collected(int level);

  std::array<Level, kMaxLevels> levels_;
  bool counting_ = false;
};

}  // namespace mres
