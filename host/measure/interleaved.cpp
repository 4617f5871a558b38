#include "host/measure/interleaved.h"

#include <algorithm>

namespace host {
namespace {

void warmUp(const Work& work, const Timer& timer, double seconds) {
  double spent = 0.0;
  do spent += timer(work).wallMs / 1000.0;
  while (spent < seconds);
}

bool isEnough(const InterleavedTimes& times, const RepeatPlan& plan, double spentSeconds) {
  const int pairs = static_cast<int>(times.technique.size());
  if (plan.pairs) return pairs >= *plan.pairs;
  if (pairs < plan.minPairs) return false;
  return pairs >= plan.maxPairs || spentSeconds >= plan.maxSeconds ||
         speedupOf(times).isKnownWithin(plan.precision);
}

}  // namespace

InterleavedTimes timeInterleaved(const Work& technique, const Work& reference, const Timer& timer,
                                 const RepeatPlan& plan, const PairObserver& observe) {
  warmUp(technique, timer, plan.warmUpSeconds);
  warmUp(reference, timer, plan.warmUpSeconds);

  InterleavedTimes times;
  double spentSeconds = 0.0;
  while (!isEnough(times, plan, spentSeconds)) {
    times.technique.push_back(timer(technique));
    times.reference.push_back(timer(reference));
    spentSeconds += (times.technique.back().wallMs + times.reference.back().wallMs) / 1000.0;
    if (observe) observe(static_cast<int>(times.technique.size()), plan.pairs.value_or(plan.maxPairs));
  }
  return times;
}

std::vector<RunTime> timeAlone(const Work& work, const Timer& timer, int runs) {
  warmUp(work, timer, RepeatPlan().warmUpSeconds);
  std::vector<RunTime> times;
  while (static_cast<int>(times.size()) < runs) times.push_back(timer(work));
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
  const auto hasGpuTime = [](const RunTime& run) { return run.gpuMs.has_value(); };
  return std::ranges::all_of(times.technique, hasGpuTime) && std::ranges::all_of(times.reference, hasGpuTime)
             ? Clock::gpu
             : Clock::wall;
}

RatioEstimate speedupOf(const InterleavedTimes& times) {
  const Clock clock = trustedClock(times);
  return ratioOfMedians(*timesBy(clock, times.reference), *timesBy(clock, times.technique));
}

}  // namespace host
