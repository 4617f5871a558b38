#include "host/commands/bench_cost.h"

#include <algorithm>
#include <map>

namespace host {
namespace {

/// Of an effect on llvmpipe on two cores.
struct Cost {
  double nanosecondsPerSample;      ///< at full resolution
  double share;                     ///< of the time at full resolution that the technique takes
  double truthSecondsPerMegapixel;  ///< of rays, and of converging passes besides their samples
};

Cost costOf(const std::string& effect) {
  static const std::map<std::string, Cost> kCosts{
      {"ssao", {3.8, 0.6, 0.8}}, {"ssm", {1.7, 0.4, 0.3}}, {"ssgi", {4.5, 0.3, 0.2}}};
  const auto known = kCosts.find(effect);
  return known != kCosts.end() ? known->second : Cost{7.7, 0.55, 0.8};
}

double pixelsOf(const BenchCase& benchCase) {
  return static_cast<double>(benchCase.size.x) * static_cast<double>(benchCase.size.y);
}

double referenceSeconds(const BenchCase& benchCase) {
  return costOf(benchCase.effect).nanosecondsPerSample * 1e-9 * benchCase.samples * pixelsOf(benchCase);
}

double pairSeconds(const BenchCase& benchCase) {
  return (1.0 + costOf(benchCase.effect).share) * referenceSeconds(benchCase);
}

// With these, the paper's suite takes at most 97 minutes, truths included; a test adds them up.
constexpr double kMaxSeconds = 2.5;
constexpr double kMaxSecondsOfMinPairs = 10.0;
constexpr int kMinPairs = 3;

// Longer than this, a frame is hardly slower for being the first.
constexpr double kSecondsOfSlowFrames = 3.0;

// Geometry, read-back and error metrics; then everything else.
constexpr double kSecondsPerMegapixel = 0.4;
constexpr double kSecondsPerCase = 0.5;
constexpr double kSecondsOfPictures = 6.0;
constexpr double kInspectedFrames = 3.0;  // of the technique, for its stages

/// Samples of the converged reference, for each pixel of the picture: 4096 at a sixteenth of them.
constexpr int kTruthSamples = 256;

double truthSeconds(const BenchCase& benchCase) {
  if (!benchCase.truth) return 0.0;
  BenchCase converged = benchCase;
  converged.samples = kTruthSamples;
  return referenceSeconds(converged) +
         costOf(benchCase.effect).truthSecondsPerMegapixel * 1e-6 * pixelsOf(benchCase);
}

/// Once to warm up, then as often as the plan allows.
double timedSeconds(const BenchCase& benchCase, const RepeatPlan& plan) {
  const double pair = pairSeconds(benchCase);
  const double warmUp = plan.warmUpSeconds > 0.0 ? pair + 2.0 * plan.warmUpSeconds : 0.0;
  if (plan.pairs) return warmUp + *plan.pairs * pair;
  return warmUp + std::min(std::max(plan.minPairs * pair, plan.maxSeconds + pair), plan.maxPairs * pair);
}

}  // namespace

RepeatPlan planOf(const BenchCase& benchCase) {
  RepeatPlan plan;
  plan.minPairs = static_cast<int>(
      std::clamp(kMaxSecondsOfMinPairs / pairSeconds(benchCase), 1.0, static_cast<double>(kMinPairs)));
  plan.maxSeconds = kMaxSeconds;
  if (referenceSeconds(benchCase) > kSecondsOfSlowFrames) plan.warmUpSeconds = 0.0;
  return plan;
}

double secondsOf(const BenchCase& benchCase, const RepeatPlan& plan) {
  return timedSeconds(benchCase, plan) +
         kInspectedFrames * costOf(benchCase.effect).share * referenceSeconds(benchCase) +
         kSecondsPerMegapixel * 1e-6 * pixelsOf(benchCase) + kSecondsPerCase + truthSeconds(benchCase) +
         (benchCase.pictures ? kSecondsOfPictures : 0.0);
}

}  // namespace host
