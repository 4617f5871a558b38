#include "host/bench/cost.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "host/measure/truth_finder.h"

namespace host {
namespace {

/// Of an effect on llvmpipe on two cores.
struct Cost {
  double nanosecondsPerSample;      ///< at full resolution
  double share;                     ///< of the time at full resolution that the technique takes
  double truthSecondsPerMegapixel;  ///< of rays, and of converging passes besides their samples
};

const Cost& costOf(const std::string& effect) {
  static const std::map<std::string, Cost> kCosts{
      {"ssao", {3.8, 0.5, 0.8}}, {"ssm", {1.4, 0.35, 0.3}}, {"ssgi", {5.8, 0.23, 0.2}}};
  return kCosts.at(effect);
}

double pixelsOf(const BenchCase& benchCase) {
  return static_cast<double>(benchCase.size.x) * static_cast<double>(benchCase.size.y);
}

double referenceSeconds(const BenchCase& benchCase) {
  return costOf(benchCase.effect).nanosecondsPerSample * 1e-9 * referenceSamplesOf(benchCase) *
         pixelsOf(benchCase);
}

/// Of the reference's time, what mres's rivals take, about.
double shareOf(const BenchCase& benchCase) {
  static const std::map<std::string, double> kShares{
      {"half-bilinear", 0.3},  {"half-joint", 0.35},    {"quarter-bilinear", 0.12},
      {"quarter-joint", 0.2},  {"checkerboard", 0.65},  {"interleaved", 1.05},
      {kPaperTechnique, 0.85}, {kMinMaxTechnique, 0.6}, {kAdaptiveTilesTechnique, 0.5}};
  constexpr double kWithoutSamples = 0.2;
  if (benchCase.technique == kFullTechnique)
    return std::lerp(kWithoutSamples, 1.0,
                     static_cast<double>(benchCase.samples) / referenceSamplesOf(benchCase));
  const auto rival = kShares.find(benchCase.technique);
  return rival == kShares.end() ? costOf(benchCase.effect).share : rival->second;
}

double techniqueSeconds(const BenchCase& benchCase) {
  return shareOf(benchCase) * referenceSeconds(benchCase);
}

// Geometry, read-back and error metrics; then everything else.
constexpr double kSecondsPerMegapixel = 0.4;
constexpr double kSecondsPerCase = 0.5;
constexpr double kSecondsOfPictures = 6.0;
constexpr double kSecondsOfWorstPlacePerMegapixel = 0.3;
constexpr double kInspectedFrames = 3.0;  // of the technique, for its stages

double truthSeconds(const BenchCase& benchCase) {
  if (!benchCase.truth) return 0.0;
  BenchCase converged = benchCase;
  converged.referenceSamples =
      convergedSamples(referenceSamplesOf(benchCase)) / (kConvergedStride.x * kConvergedStride.y);
  return referenceSeconds(converged) +
         costOf(benchCase.effect).truthSecondsPerMegapixel * 1e-6 * pixelsOf(benchCase);
}

double flickerSeconds(const BenchCase& benchCase) {
  const double geometry = kSecondsPerMegapixel * 1e-6 * pixelsOf(benchCase);
  return benchCase.frames * (techniqueSeconds(benchCase) + referenceSeconds(benchCase) + geometry);
}

/// As timeInterleaved() has it.
double warmUpSeconds(const BenchCase& benchCase, const RepeatPlan& plan) {
  const auto untilWarm = [&plan](double run) { return std::ceil(plan.warmUpSeconds / run) * run; };
  const double technique = untilWarm(techniqueSeconds(benchCase));
  return technique > plan.maxSecondsOfWarmUp ? technique : technique + untilWarm(referenceSeconds(benchCase));
}

/// As timeInterleaved() has it, of times that never get certain.
double pairsSeconds(const BenchCase& benchCase, const RepeatPlan& plan) {
  const double pair = techniqueSeconds(benchCase) + referenceSeconds(benchCase);
  if (plan.pairs) return *plan.pairs * pair;
  const double affordable = std::floor(plan.maxSecondsOfMinPairs / pair);
  if (affordable < plan.minPairs) return std::max(affordable, 1.0) * pair;
  return std::min(std::max(plan.minPairs * pair, plan.maxSeconds + pair), plan.maxPairs * pair);
}

/// A few frames by levels, and sometimes some by the plain effect.
double calibrationSeconds(const BenchCase& benchCase) {
  constexpr double kFrames = 2.0;
  return benchCase.technique == kMresTechnique ? kFrames * techniqueSeconds(benchCase) : 0.0;
}

}  // namespace

// With these, the paper's suite keeps within its 110 minutes, truths included; a test adds them up.
RepeatPlan campaignPlan() {
  return {.minPairs = 3, .maxSeconds = 1.5, .maxSecondsOfMinPairs = 5.5};
}

// With these, the pareto suite keeps within an hour; a test adds them up.
RepeatPlan paretoPlan() {
  return {.minPairs = 3, .maxSeconds = 0.8, .maxSecondsOfMinPairs = 5.0};
}

double secondsOf(const BenchCase& benchCase, const RepeatPlan& plan) {
  return calibrationSeconds(benchCase) + warmUpSeconds(benchCase, plan) + pairsSeconds(benchCase, plan) +
         (benchCase.stages ? kInspectedFrames * techniqueSeconds(benchCase) : 0.0) +
         flickerSeconds(benchCase) + kSecondsPerMegapixel * 1e-6 * pixelsOf(benchCase) + kSecondsPerCase +
         truthSeconds(benchCase) + (benchCase.pictures ? kSecondsOfPictures : 0.0) +
         (benchCase.worstPlace ? kSecondsOfWorstPlacePerMegapixel * 1e-6 * pixelsOf(benchCase) : 0.0);
}

}  // namespace host
