#include "host/measure/interleaved.h"

#include <algorithm>

namespace host {
namespace {

/// Reports how far the timing of a plan is.
class Steps {
 public:
  Steps(const RepeatPlan& plan, const RunObserver& observe)
      : expected_(plan.pairs.value_or(plan.maxPairs)), observe_(observe) {}

  void done(std::size_t count) const {
    if (observe_) observe_(static_cast<int>(count), expected_);
  }

 private:
  int expected_;
  const RunObserver& observe_;
};

/// What it took.
double warmUp(const Work& work, const Timer& timer, double seconds, const Steps& steps) {
  double spent = 0.0;
  while (spent < seconds) {
    steps.done(0);
    spent += timer(work).wallMs / 1000.0;
  }
  return spent;
}

bool isEnough(std::size_t runs, const RepeatPlan& plan, double spentSeconds,
              const std::function<RatioEstimate()>& estimate) {
  const int done = static_cast<int>(runs);
  if (plan.pairs) return done >= *plan.pairs;
  if (done == 0) return false;
  if (done < plan.minPairs) return spentSeconds / done * (done + 1) > plan.maxSecondsOfMinPairs;
  return done >= plan.maxPairs || spentSeconds >= plan.maxSeconds || estimate().isKnownWithin(plan.precision);
}

RatioEstimate medianOf(const std::vector<RunTime>& runs) {
  return estimateMedian(*timesBy(trustedClock({runs, {}}), runs));
}

}  // namespace

InterleavedTimes timeInterleaved(const Work& technique, const Work& reference, const Timer& timer,
                                 const RepeatPlan& plan, const RunObserver& observe) {
  const Steps steps(plan, observe);
  if (warmUp(technique, timer, plan.warmUpSeconds, steps) <= plan.maxSecondsOfWarmUp)
    warmUp(reference, timer, plan.warmUpSeconds, steps);

  InterleavedTimes times;
  double spentSeconds = 0.0;
  while (!isEnough(times.technique.size(), plan, spentSeconds, [&] { return speedupOf(times); })) {
    times.technique.push_back(timer(technique));
    times.reference.push_back(timer(reference));
    spentSeconds += (times.technique.back().wallMs + times.reference.back().wallMs) / 1000.0;
    steps.done(times.technique.size());
  }
  return times;
}

std::vector<RunTime> timeAlone(const Work& work, const Timer& timer, const RepeatPlan& plan,
                               const RunObserver& observe) {
  const Steps steps(plan, observe);
  warmUp(work, timer, plan.warmUpSeconds, steps);

  std::vector<RunTime> times;
  double spentSeconds = 0.0;
  while (!isEnough(times.size(), plan, spentSeconds, [&] { return medianOf(times); })) {
    times.push_back(timer(work));
    spentSeconds += times.back().wallMs / 1000.0;
    steps.done(times.size());
  }
  return times;
}

std::optional<std::vector<double>> timesBy(Clock clock, const std::vector<RunTime>& runs) {
  std::vector<double> values;
  values.reserve(runs.size());
  for (const RunTime& run : runs) {
    if (clock == Clock::wall)
      values.push_back(run.wallMs);
    else if (run.gpuMs)
      values.push_back(*run.gpuMs);
    else
      return std::nullopt;
  }
  return values;
}

Clock trustedClock(const InterleavedTimes& times) {
  const auto trustsGpu = [](const RunTime& run) { return run.trusted == Clock::gpu && run.gpuMs; };
  return std::ranges::all_of(times.technique, trustsGpu) && std::ranges::all_of(times.reference, trustsGpu)
             ? Clock::gpu
             : Clock::wall;
}

RatioEstimate speedupOf(const InterleavedTimes& times) {
  const Clock clock = trustedClock(times);
  return ratioOfMedians(*timesBy(clock, times.reference), *timesBy(clock, times.technique));
}

}  // namespace host
