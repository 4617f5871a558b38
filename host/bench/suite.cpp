#include "host/bench/suite.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <tuple>

#include "host/bench/pareto_suite.h"
#include "host/console/parse.h"
#include "host/console/usage_error.h"

namespace host {
namespace {

constexpr glm::ivec2 k720p{1280, 720};
constexpr glm::ivec2 k1080p{1920, 1080};
constexpr glm::ivec2 k1440p{2560, 1440};
constexpr glm::ivec2 k4k{3840, 2160};

using Cases = std::vector<BenchCase>;
using MakeCases = Cases (*)(const SuiteRequest& request);

/// The samples of one effect in the paper's evaluation.
struct PaperEffect {
  std::string name;
  int samples;             ///< figure 6
  int errorSamples;        ///< figure 10
  std::vector<int> sweep;  ///< figure 5
  std::vector<int> once;   ///< figure 5, too slow for more than one view
};

const std::vector<PaperEffect>& paperEffects() {
  static const std::vector<PaperEffect> kEffects{{"ssao", 64, 64, {16, 32, 64, 128}, {}},
                                                 {"ssm", 196, 196, {49, 100, 196, 400}, {}},
                                                 {"ssgi", 228, 288, {72, 144, 228, 288, 528}, {4224}}};
  return kEffects;
}

/// Ordered so that shaders and targets serve as many cases as they can; a picture that several figures show
/// is there once, with all that these want of it.
Cases sortedDistinct(Cases cases) {
  const auto key = [](const BenchCase& each) {
    return std::tuple(each.samples, each.size.x, each.size.y, each.camera);
  };
  std::ranges::stable_sort(cases, {}, key);
  Cases distinct;
  for (const BenchCase& each : cases) {
    if (distinct.empty() || key(distinct.back()) != key(each)) distinct.push_back(each);
    BenchCase& kept = distinct.back();
    kept.pictures |= each.pictures;
    kept.truth |= each.truth;
    kept.worstPlace |= each.worstPlace;
  }
  return distinct;
}

std::vector<BenchScene> scenesOf(const SuiteRequest& request) {
  if (!request.scenes.empty()) return request.scenes;
  return {{"hall", "hall"}, {"breakfast", "breakfast"}, {"office", "office"}};
}

/// One view of every scene, and for one view how size and samples change the gain: the paper's figures 5 to
/// 10 in small.
Cases quickSuite(const SuiteRequest& request) {
  Cases cases;
  bool isFirst = true;
  for (const BenchScene& scene : scenesOf(request)) {
    for (const PaperEffect& effect : paperEffects()) {
      Cases some{{scene, effect.name, effect.samples, k1080p, 0, true}};
      if (isFirst)
        some.insert(some.end(), {{scene, effect.name, effect.samples, k720p, 0},
                                 {scene, effect.name, effect.samples, k1440p, 0},
                                 {scene, effect.name, effect.samples / 2, k720p, 0},
                                 {scene, effect.name, effect.samples / 4, k720p, 0}});
      std::ranges::copy(sortedDistinct(some), std::back_inserter(cases));
    }
    isFirst = false;
  }
  return cases;
}

constexpr int kPaperCameras = 8;

Cases paperCases(const BenchScene& scene, const PaperEffect& effect, const std::vector<int>& sweptCameras) {
  Cases cases;
  for (int camera = 0; camera < kPaperCameras; ++camera) {
    for (const glm::ivec2 size : {k720p, k1080p, k1440p, k4k})
      cases.push_back(
          {scene, effect.name, effect.samples, size, camera, camera == 0 && size == k1080p, size == k1080p});
    cases.push_back({.scene = scene,
                     .effect = effect.name,
                     .samples = effect.errorSamples,
                     .size = k4k,
                     .camera = camera,
                     .worstPlace = true});
  }
  for (const int camera : sweptCameras)
    for (const int samples : effect.sweep) cases.push_back({scene, effect.name, samples, k4k, camera});
  return cases;
}

/// The evaluation of Besenthal, Maisch and Ropinski 2019, figures 5 to 10, and for one size what the paper
/// leaves open: whether its reference is any nearer to the truth.
Cases paperSuite(const SuiteRequest& request) {
  std::vector<int> sweptCameras{0, 4};  // of three scenes six views: they alone take a quarter of the time
  if (request.thorough) {
    sweptCameras.resize(kPaperCameras);
    std::iota(sweptCameras.begin(), sweptCameras.end(), 0);
  }
  Cases cases;
  bool isFirst = true;
  for (const BenchScene& scene : scenesOf(request)) {
    for (const PaperEffect& effect : paperEffects()) {
      Cases some = paperCases(scene, effect, sweptCameras);
      if (isFirst)
        for (const int samples : effect.once) some.push_back({scene, effect.name, samples, k4k, 0});
      std::ranges::copy(sortedDistinct(some), std::back_inserter(cases));
    }
    isFirst = false;
  }
  return cases;
}

/// What the tests run: a campaign of seconds that has every effect, a plot, a picture and a truth. Its
/// numbers mean nothing, so users are not offered it.
Cases smokeSuite(const SuiteRequest& request) {
  const std::vector<BenchScene> scenes =
      request.scenes.empty() ? std::vector<BenchScene>{{"office", "office"}} : request.scenes;
  Cases cases;
  for (const BenchScene& scene : scenes)
    cases.insert(cases.end(), {{.scene = scene,
                                .effect = "ssao",
                                .samples = 4,
                                .size = {64, 36},
                                .pictures = true,
                                .truth = true,
                                .worstPlace = true},
                               {scene, "ssao", 4, {32, 18}, 0},
                               {scene, "ssm", 4, {64, 36}, 0},
                               {scene, "ssgi", 8, {64, 36}, 0}});
  return cases;
}

/// Time against error: what it takes to have every technique's.
Cases paretoSuite(const SuiteRequest& request) {
  Cases cases;
  for (const BenchScene& scene : scenesOf(request))
    std::ranges::copy(paretoCases(scene, request.thorough), std::back_inserter(cases));
  return cases;
}

/// The same in seconds, for the tests.
Cases paretoSmokeSuite(const SuiteRequest& request) {
  Cases cases;
  for (const BenchScene& scene : request.scenes)
    std::ranges::copy(paretoSmokeCases(scene), std::back_inserter(cases));
  return cases;
}

MakeCases suiteOf(const std::string& name) {
  if (name == "quick") return quickSuite;
  if (name == kPaperSuite) return paperSuite;
  if (name == kParetoSuite) return paretoSuite;
  if (name == "smoke") return smokeSuite;
  if (name == "pareto-smoke") return paretoSmokeSuite;
  throw UsageError(fmt::format("There is no suite '{}'{}", name, suggestion(name, suiteNames())));
}

}  // namespace

const std::vector<std::string>& suiteNames() {
  static const std::vector<std::string> kNames{"quick", kPaperSuite, kParetoSuite};
  return kNames;
}

std::vector<BenchCase> suiteCases(const SuiteRequest& request) {
  return suiteOf(request.suite)(request);
}

int referenceSamplesOf(const BenchCase& benchCase) {
  return benchCase.referenceSamples > 0 ? benchCase.referenceSamples : benchCase.samples;
}

std::string nameOf(const BenchCase& benchCase) {
  const std::string name =
      fmt::format("{} {} {}x{} {} {}", benchCase.scene.name, benchCase.camera, benchCase.size.x,
                  benchCase.size.y, benchCase.effect, benchCase.samples);
  return benchCase.technique == kMresTechnique ? name : fmt::format("{} {}", name, benchCase.technique);
}

}  // namespace host
