#pragma once

#include <optional>

#include "mres/plan/costs.h"
#include "mres/plan/frame_cost.h"

namespace mres {

/// Chooses between levels and the plain effect by what frames took, so that levels are never the slower of
/// the two for long. While nothing is known, levels render.
///
/// A choice is changed when the other one is expected to be faster by kWorthChanging for kFramesToChange
/// frames in a row. What levels evaluate is not known while the plain effect renders: levels are tried again
/// after a while, which doubles with every try that did not pay.
class PlanChooser {
 public:
  static constexpr double kWorthChanging = 0.05;
  static constexpr int kFramesToChange = 8;
  static constexpr int kFramesToRetry = 600;

  [[nodiscard]] bool choosesLevels() const { return levels_; }
  /// None while nothing is known.
  [[nodiscard]] const std::optional<Costs>& costs() const { return costs_; }

  /// Takes the faster one at once; nothing known starts anew, with levels.
  void setCosts(const std::optional<Costs>& costs);

  /// A frame of `pixels`, of which levels evaluated `work` as a share. Frames of before a change, whose times
  /// come late, count for nothing.
  void observe(const FrameCost& frame, double work, double pixels);

 private:
  void observeLevels(const FrameCost& frame, double work, double pixels);
  void observePlain(const FrameCost& frame, double pixels);
  void approach(double& known, double seen) const;
  void reconsider();
  void change();

  std::optional<Costs> costs_;
  bool levels_ = true;
  int framesAgainst_ = 0;   // in a row, for which the other choice was expected to be faster
  int framesOfChoice_ = 0;  // observed since it was made
  int framesToRetry_ = kFramesToRetry;
};

}  // namespace mres
