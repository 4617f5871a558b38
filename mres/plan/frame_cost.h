#pragma once

#include <vector>

#include "mres/gl/profiler.h"

namespace mres {

/// Where a frame's time went, as far as plans differ in it.
struct FrameCost {
  double sharedMs = 0.0;
  double overheadMs = 0.0;
  double evaluationMs = 0.0;
  bool byLevels = false;  ///< whether it was made by levels

  [[nodiscard]] double totalMs() const { return sharedMs + overheadMs + evaluationMs; }
};

FrameCost frameCost(const std::vector<gl::StageTime>& stages);

}  // namespace mres
