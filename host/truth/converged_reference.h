#pragma once

#include <functional>
#include <memory>
#include <string>

#include "host/truth/truth.h"
#include "host/truth/work_observer.h"
#include "mres/mres.h"

namespace host {

/// The effect of pass 0, 1, ...: the same but for its sample points.
using EffectOfPass = std::function<std::unique_ptr<mres::Effect>(int pass)>;

/// A set of passes whose mean has converged.
struct ConvergingPasses {
  EffectOfPass effect;
  int passes = 1;
  int samples = 0;  ///< a pixel in each pass
};

/// It is found in blocks of 4x4 pixels, which llvmpipe shades at once, and of those in one of so many along
/// each axis: all in all at about as many pixels as a quarter level has.
inline constexpr glm::ivec2 kConvergedStride{5, 3};

/// An effect with so many samples that more would change little, and without its filter: what the same
/// algorithm gives when nothing is saved. Needs a current OpenGL context.
class ConvergedReference {
 public:
  /// Shader files below `shaderDirectory`, if it isn't empty, win over the embedded ones.
  explicit ConvergedReference(const std::string& shaderDirectory);

  /// The mean of all passes, at a fifteenth of the pixels. `observe` is called before each pass.
  Truth render(const ConvergingPasses& passes, const mres::Frame& frame, const WorkObserver& observe);

 private:
  mres::MultiResolution multiResolution_;
};

}  // namespace host
