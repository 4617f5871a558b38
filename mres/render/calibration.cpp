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

// Of several frames the fastest counts, as the one that other work on the machine disturbed least.
constexpr int kMostFrames = 5;
constexpr double kEnoughMs = 100.0;  // of frames of one kind

/// Has the profiler in a mode, as long as it lives.
class ProfilerMode {
 public:
  ProfilerMode(gl::Profiler& profiler, gl::Profiler::Mode mode)
      : profiler_(profiler), before_(profiler.nextMode()) {
    profiler_.setMode(mode);
  }
  ~ProfilerMode() { profiler_.setMode(before_); }
  ProfilerMode(const ProfilerMode&) = delete;
  ProfilerMode& operator=(const ProfilerMode&) = delete;

 private:
  gl::Profiler& profiler_;
  gl::Profiler::Mode before_;
};

FrameCost leastOf(const FrameCost& a, const FrameCost& b) {
  return {.sharedMs = std::min(a.sharedMs, b.sharedMs),
          .overheadMs = std::min(a.overheadMs, b.overheadMs),
          .evaluationMs = std::min(a.evaluationMs, b.evaluationMs),
          .byLevels = a.byLevels};
}

double millisecondsOf(const CalibratedFrame& frame, Technique technique) {
  glFinish();
  const auto start = std::chrono::steady_clock::now();
  frame.render(technique, false);
  glFinish();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The stages of a frame by levels, each waited for.
FrameCost stagedFrame(const CalibratedFrame& frame) {
  const ProfilerMode waiting(frame.profiler, gl::Profiler::Mode::finish);
  FrameCost least;
  double spentMs = 0.0;
  for (int i = 0; i < kMostFrames && spentMs < kEnoughMs; ++i) {
    frame.render(Technique::multiResolution, true);
    const FrameCost cost = frameCost(frame.profiler.stages());
    least = i == 0 ? cost : leastOf(least, cost);
    spentMs += cost.totalMs();
  }
  return least;
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

/// By turns, so that both see the same machine.
Times timeBoth(const CalibratedFrame& frame) {
  const ProfilerMode unwatched(frame.profiler, gl::Profiler::Mode::off);
  Times times;
  frame.render(Technique::full, false);  // sets up what only that needs
  double spentMs = 0.0;
  for (int pair = 0; pair < kMostFrames && spentMs < 2.0 * kEnoughMs; ++pair) {
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
  const FrameCost staged = stagedFrame(frame);
  const double work = frame.work();
  const Costs roughly = costsOf(staged, staged.totalMs(), work, frame.pixels);
  if (roughly.plain() > kClearly * roughly.levels()) return roughly;

  const Times times = timeBoth(frame);
  Costs costs = costsOf(staged, times.levelsMs, work, frame.pixels);
  const double plain = times.plainMs * 1e6 / frame.pixels;
  // Where inputs seem to take longer than the whole, they are noise.
  costs.scatter = costs.evaluation / std::max(plain - costs.shared, 0.1 * plain);
  return costs;
}

}  // namespace mres
