#pragma once

#include <optional>

namespace mres {

/// What an effect takes by levels and by the plain effect at every pixel, in nanoseconds per pixel of the
/// full resolution, so that it means about the same at every size.
struct Costs {
  double shared = 0.0;      ///< whatever is planned: depth pyramid, the effect's inputs
  double overhead = 0.0;    ///< of levels: edges, masks, stencils, upsampling
  double evaluation = 0.0;  ///< per pixel that a level evaluates, filter and blend included
  double work = 0.0;        ///< pixels that all levels evaluate, as a share of the full resolution's
  /// A pixel's evaluation in levels over that in the plain effect: scattered zones cost more.
  double scatter = 1.0;

  [[nodiscard]] double levels() const { return shared + overhead + work * evaluation; }
  [[nodiscard]] double plain() const { return shared + evaluation / scatter; }
};

}  // namespace mres
