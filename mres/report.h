#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "mres/gl/profiler.h"
#include "mres/plan/costs.h"
#include "mres/settings.h"

namespace mres {

/// Something that a frame did not need. Both are string literals.
struct Skip {
  std::string_view what;
  std::string_view reason;
};

/// One level that was rendered.
struct LevelReport {
  int index = 0;  ///< 0 full, 1 half, 2 quarter, 3 eighth resolution
  glm::ivec2 size{0};
  /// Share of the level's pixels in which the effect ran; needs Options::measureCoverage.
  double coverage = 1.0;
};

/// What the plan was chosen by.
struct PlanReport {
  bool fallsBack = false;      ///< the plain effect stood in for levels
  std::string_view reason;     ///< a string literal
  std::optional<Costs> costs;  ///< none while nothing is known
};

/// What the last render() did.
struct Report {
  Technique technique = Technique::full;
  PlanReport plan;
  std::vector<LevelReport> levels;  ///< finest first
  std::vector<Skip> skipped;
  std::vector<gl::StageTime> stages;  ///< of the latest frame known; empty while profiling is off
  std::size_t bytes = 0;  ///< of GPU memory that mres holds for this effect, shared buffers included
};

}  // namespace mres
