#include "mres/plan/plan_chooser.h"

#include <algorithm>

namespace mres {
namespace {

/// Of a new frame in what is known, at the least: single frames vary.
constexpr double kShareOfFrame = 0.1;

constexpr int kLongestRetry = 16 * PlanChooser::kFramesToRetry;

double nanosecondsPerPixel(double milliseconds, double pixels) {
  return milliseconds * 1e6 / pixels;
}

}  // namespace

void PlanChooser::setCosts(const std::optional<Costs>& costs) {
  costs_ = costs;
  levels_ = !costs || costs->levels() <= costs->plain();
  framesAgainst_ = 0;
  framesOfChoice_ = 0;
  framesToRetry_ = kFramesToRetry;
}

// The mean of the first frames of a choice, later mostly of the last.
void PlanChooser::approach(double& known, double seen) const {
  known += std::max(kShareOfFrame, 1.0 / (1 + framesOfChoice_)) * (seen - known);
}

void PlanChooser::observe(const FrameCost& frame, double work, double pixels) {
  if (frame.byLevels != levels_) return;
  if (frame.byLevels)
    observeLevels(frame, work, pixels);
  else
    observePlain(frame, pixels);
  if (costs_) reconsider();
}

void PlanChooser::observeLevels(const FrameCost& frame, double work, double pixels) {
  const double evaluated = work * pixels;
  if (evaluated <= 0.0) return;
  const Costs seen{.shared = nanosecondsPerPixel(frame.sharedMs, pixels),
                   .overhead = nanosecondsPerPixel(frame.overheadMs, pixels),
                   .evaluation = nanosecondsPerPixel(frame.evaluationMs, evaluated),
                   .work = work};
  if (!costs_) costs_ = seen;
  approach(costs_->shared, seen.shared);
  approach(costs_->overhead, seen.overhead);
  approach(costs_->evaluation, seen.evaluation);
  approach(costs_->work, seen.work);
}

void PlanChooser::observePlain(const FrameCost& frame, double pixels) {
  if (!costs_) return;  // of levels, nothing is known to compare with
  approach(costs_->shared, nanosecondsPerPixel(frame.sharedMs, pixels));
  approach(costs_->evaluation, nanosecondsPerPixel(frame.evaluationMs, pixels) * costs_->scatter);
}

void PlanChooser::reconsider() {
  const double present = levels_ ? costs_->levels() : costs_->plain();
  const double other = levels_ ? costs_->plain() : costs_->levels();
  framesAgainst_ = other < present * (1.0 - kWorthChanging) ? framesAgainst_ + 1 : 0;
  ++framesOfChoice_;
  const bool retries = !levels_ && framesOfChoice_ >= framesToRetry_;
  if (retries) framesToRetry_ = std::min(2 * framesToRetry_, kLongestRetry);
  if (retries || framesAgainst_ >= kFramesToChange) change();
}

void PlanChooser::change() {
  const bool paid = levels_ && framesOfChoice_ > 2 * kFramesToChange;
  if (paid) framesToRetry_ = kFramesToRetry;
  levels_ = !levels_;
  framesAgainst_ = 0;
  framesOfChoice_ = 0;
}

}  // namespace mres
