// Timing two pieces of work against each other: A B A B, so that both see the same machine.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "host/measure/statistics.h"

namespace host {

enum class Clock {
  wall,  ///< glFinish and a monotonic clock
  gpu    ///< GL_TIME_ELAPSED
};

/// What one run took.
struct RunTime {
  double wallMs = 0.0;
  std::optional<double> gpuMs = std::nullopt;
  Clock trusted = Clock::wall;  ///< the one that tells how long the work took
};

using Work = std::function<void()>;
using Timer = std::function<RunTime(const Work&)>;

/// How often to repeat. Without a fixed count: until the ratio (or median) is known within `precision`, or
/// the most pairs or the most seconds are reached, whichever comes first.
struct RepeatPlan {
  std::optional<int> pairs = std::nullopt;  ///< exactly so many, at least 1; of one work alone, runs
  int minPairs = 6;                         ///< fewer say little about a median
  int maxPairs = 31;
  double maxSeconds = 20.0;  ///< of timed work
  /// Fewer than `minPairs` are enough if another one would take the time beyond this; one is timed always.
  double maxSecondsOfMinPairs = 60.0;
  double precision = 0.05;  ///< half of the interval's width, relative to the ratio
  /// Each is run until this has passed, to compile its shaders and allocate. The reference is not if the
  /// technique's run alone took longer than `maxSecondsOfWarmUp`: of work so long warming up changes
  /// nothing.
  double warmUpSeconds = 0.1;
  double maxSecondsOfWarmUp = 1.0;
};

struct InterleavedTimes {
  std::vector<RunTime> technique;
  std::vector<RunTime> reference;
};

/// Called before every run that warms up, with none done, and after every timed run or pair, with those done;
/// `expected` is their number at most.
using RunObserver = std::function<void(int done, int expected)>;

InterleavedTimes timeInterleaved(const Work& technique, const Work& reference, const Timer& timer,
                                 const RepeatPlan& plan, const RunObserver& observe = {});

/// One piece of work alone, by the same plan: until its median is known.
std::vector<RunTime> timeAlone(const Work& work, const Timer& timer, const RepeatPlan& plan,
                               const RunObserver& observe = {});

/// The wall times, or the GPU times where every run has one.
std::optional<std::vector<double>> timesBy(Clock clock, const std::vector<RunTime>& runs);

/// The clock to trust: GPU time where every run of both has one and trusts it, else wall time.
Clock trustedClock(const InterleavedTimes& times);

/// Reference over technique, by the trusted clock.
RatioEstimate speedupOf(const InterleavedTimes& times);

}  // namespace host
