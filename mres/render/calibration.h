#pragma once

#include <functional>

#include "mres/gl/profiler.h"
#include "mres/plan/costs.h"
#include "mres/settings.h"

namespace mres {

/// What is calibrated: one effect and one frame.
struct CalibratedFrame {
  gl::Profiler& profiler;
  std::function<void(Technique, bool counting)> render;  ///< `counting` what `work` is made of
  std::function<double()> work;  ///< of the last frame by levels that counted; see Costs::work
  double pixels = 0.0;           ///< of the full resolution
};

/// After a first frame by levels, which compiles and allocates: renders the frame a few times by levels and,
/// unless these are clearly faster, by the plain effect, and waits for each: on a GPU some milliseconds in
/// all. Leaves the profiler's mode as it was.
Costs measureCosts(const CalibratedFrame& frame);

}  // namespace mres
