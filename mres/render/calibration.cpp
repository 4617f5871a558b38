#include "mres/render/calibration.h"

#include <algorithm>
#include <chrono>
#include <epoxy/gl.h>
#include <limits>

#include "mres/plan/frame_cost.h"

namespace mres {
namespace {

/// How many times faster than the plain effect levels must look for that not to be worth a measurement.
constexpr double kClearly = 3.0;

constexpr int kMostPairs = 5;
constexpr double kEnoughMs = 250.0;  // of timed frames

/// Waits for each stage, as long as it lives.
class WaitingProfiler {
 public:
  explicit WaitingProfiler(gl::Profiler& profiler) : profiler_(profiler), before_(profiler.mode()) {
    profiler_.setMode(gl::Profiler::Mode::finish);
  }
  ~WaitingProfiler() { profiler_.setMode(before_); }
  WaitingProfiler(const WaitingProfiler&) = delete;
  WaitingProfiler& operator=(const WaitingProfiler&) = delete;

 private:
  gl::Profiler& profiler_;
  gl::Profiler::Mode before_;
};

double millisecondsOf(const CalibratedFrame& frame, Technique technique) {
  glFinish();
  const auto start = std::chrono::steady_clock::now();
  frame.render(technique);
  glFinish();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The stages of a frame by levels, each waited for.
FrameCost stagedFrame(const CalibratedFrame& frame) {
  const WaitingProfiler waiting(frame.profiler);
  frame.render(Technique::multiResolution);
  return frameCost(frame.profiler.stages());
}

/// By the shares of the stages, since waiting for each of them takes time too.
Costs costsOf(const FrameCost& staged, double milliseconds, double work, double pixels) {
  const double nanoseconds = milliseconds / staged.totalMs() * 1e6 / pixels;
  return {.shared = staged.sharedMs * nanoseconds,
          .overhead = staged.overheadMs * nanoseconds,
          .evaluation = staged.evaluationMs * nanoseconds / work,
          .work = work};
}

struct Times {
  double levelsMs = std::numeric_limits<double>::infinity();
  double plainMs = std::numeric_limits<double>::infinity();
};

/// The least of several, as that is what other work on the machine disturbs least.
Times timeBoth(const CalibratedFrame& frame) {
  Times times;
  frame.render(Technique::full);  // sets up what only that needs
  double spentMs = 0.0;
  for (int pair = 0; pair < kMostPairs && spentMs < kEnoughMs; ++pair) {
    const double plainMs = millisecondsOf(frame, Technique::full);
    const double levelsMs = millisecondsOf(frame, Technique::multiResolution);
    times.plainMs = std::min(times.plainMs, plainMs);
    times.levelsMs = std::min(times.levelsMs, levelsMs);
    spentMs += plainMs + levelsMs;
  }
  return times;
}

}  // namespace

Costs measureCosts(const CalibratedFrame& frame) {
  frame.render(Technique::multiResolution);  // compiles and allocates
  const FrameCost staged = stagedFrame(frame);
  const double work = frame.work();
  const double levelsMs = millisecondsOf(frame, Technique::multiResolution);
  const Costs roughly = costsOf(staged, levelsMs, work, frame.pixels);
  if (roughly.plain() > kClearly * roughly.levels()) return roughly;

  const Times times = timeBoth(frame);
  Costs costs = costsOf(staged, times.levelsMs, work, frame.pixels);
  const double plain = times.plainMs * 1e6 / frame.pixels;
  // Where inputs seem to take longer than the whole, they are noise.
  costs.scatter = costs.evaluation / std::max(plain - costs.shared, 0.1 * plain);
  return costs;
}

}  // namespace mres
