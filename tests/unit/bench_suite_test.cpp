// What the suites of `mres bench` measure, and how long that takes.
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <set>
#include <tuple>

#include "host/bench/cost.h"
#include "host/bench/suite.h"
#include "host/console/usage_error.h"
#include "host/measure/picture_settings.h"

namespace host {
namespace {

using testing::Contains;
using testing::Not;
using testing::UnorderedElementsAre;
using testing::UnorderedElementsAreArray;

constexpr glm::ivec2 k4k{3840, 2160};

std::vector<BenchCase> casesOf(const std::string& effect, const SuiteRequest& request) {
  std::vector<BenchCase> cases = suiteCases(request);
  std::erase_if(cases, [&](const BenchCase& each) { return each.effect != effect; });
  return cases;
}

std::size_t distinct(const std::vector<BenchCase>& cases) {
  std::set<std::tuple<std::string, std::string, int, int, int, int, std::string, float>> keys;
  for (const BenchCase& each : cases)
    keys.emplace(each.scene.name, each.effect, each.samples, each.size.x, each.size.y, each.camera,
                 each.technique, each.errorBudget);
  return keys.size();
}

/// How many times a new neighbour appears: no more often than there are of them if equals are together.
template <class Key>
std::size_t changes(const std::vector<BenchCase>& cases, const Key& key) {
  std::size_t count = 1;
  for (std::size_t i = 1; i < cases.size(); ++i)
    if (key(cases[i]) != key(cases[i - 1])) ++count;
  return count;
}

double seconds(const std::vector<BenchCase>& cases, const RepeatPlan& plan = campaignPlan()) {
  double sum = 0.0;
  for (const BenchCase& each : cases) sum += secondsOf(each, plan);
  return sum;
}

TEST(Suite, NamesItsCasesAndRejectsOthers) {
  EXPECT_FALSE(suiteCases({"quick"}).empty());
  EXPECT_THROW(suiteCases({"slow"}), UsageError);
  EXPECT_THAT(suiteNames(), Not(Contains("smoke")));
}

TEST(Suite, HasEveryEffectAndNoOther) {
  for (const char* suite : {"quick", "paper", "pareto", "smoke"}) {
    std::set<std::string> effects;
    for (const BenchCase& each : suiteCases({suite})) effects.insert(each.effect);
    EXPECT_THAT(effects, UnorderedElementsAreArray(effectNames())) << suite;
  }
}

TEST(Suite, MeasuresNoPictureTwice) {
  for (const char* suite : {"quick", "paper", "pareto", "smoke"})
    for (const bool thorough : {false, true}) {
      const auto cases = suiteCases({suite, {}, thorough});
      EXPECT_EQ(distinct(cases), cases.size()) << suite;
    }
}

TEST(PaperSuite, HasThePicturesOfTheFigures) {
  // 24 views in four sizes; six views with the other numbers of samples; figure 10 of SSGI; 4224 samples
  // once.
  EXPECT_EQ(casesOf("ssao", {"paper"}).size(), 24U * 4 + 6 * 3);
  EXPECT_EQ(casesOf("ssm", {"paper"}).size(), 24U * 4 + 6 * 3);
  EXPECT_EQ(casesOf("ssgi", {"paper"}).size(), 24U * 4 + 24 + 6 * 3 + 1);
}

TEST(PaperSuite, WhenThoroughHasAllViewsWithAllSamples) {
  EXPECT_EQ(casesOf("ssao", {"paper", {}, true}).size(), 24U * (4 + 3));
  EXPECT_EQ(casesOf("ssgi", {"paper", {}, true}).size(), 24U * (4 + 4) + 1);
}

TEST(PaperSuite, ShowsEachEffectInEachScene) {
  std::vector<std::string> shown;
  for (const BenchCase& each : casesOf("ssm", {"paper"}))
    if (each.pictures) shown.push_back(nameOf(each));
  EXPECT_THAT(shown, UnorderedElementsAre("hall 0 1920x1080 ssm 196", "breakfast 0 1920x1080 ssm 196",
                                          "office 0 1920x1080 ssm 196"));
}

TEST(PaperSuite, MeasuresEveryViewAndEffectInOneSizeAgainstTruth) {
  std::set<std::tuple<std::string, std::string, int>> views;
  for (const BenchCase& each : suiteCases({"paper"}))
    if (each.truth) {
      EXPECT_EQ(each.size, glm::ivec2(1920, 1080)) << nameOf(each);
      views.emplace(each.scene.name, each.effect, each.camera);
    }
  EXPECT_EQ(views.size(), 3U * 8 * effectNames().size());
}

TEST(PaperSuite, ShowsTheWorstPlaceOfEveryPictureOfFigure10) {
  std::vector<std::string> shown;
  for (const BenchCase& each : suiteCases({"paper"}))
    if (each.worstPlace) shown.push_back(nameOf(each));
  EXPECT_EQ(shown.size(), 3U * 8 * 3);
  EXPECT_THAT(shown, testing::IsSupersetOf({"hall 4 3840x2160 ssao 64", "office 7 3840x2160 ssm 196",
                                            "breakfast 0 3840x2160 ssgi 288"}));
}

TEST(QuickSuite, HasNoTimeForTruth) {
  for (const BenchCase& each : suiteCases({"quick"})) EXPECT_FALSE(each.truth) << nameOf(each);
}

TEST(PaperSuite, LoadsEachSceneOnceAndKeepsEqualSettingsTogether) {
  const auto cases = suiteCases({"paper"});
  EXPECT_EQ(changes(cases, [](const BenchCase& each) { return each.scene.name; }), 3U);
  const auto settings = [](const BenchCase& each) {
    return std::tuple(each.scene.name, each.effect, each.samples);
  };
  std::set<std::tuple<std::string, std::string, int>> all;
  std::ranges::transform(cases, std::inserter(all, all.end()), settings);
  EXPECT_EQ(changes(cases, settings), all.size());
}

TEST(PaperSuite, FitsItsTime) {
  EXPECT_LT(seconds(suiteCases({"paper"})), 106 * 60.0) << "of 110, if no ratio ever got certain";
  EXPECT_LT(seconds(suiteCases({"quick"})), 4 * 60.0);
}

std::vector<BenchCase> competing(glm::ivec2 size, const std::string& effect) {
  std::vector<BenchCase> cases = casesOf(effect, {"pareto"});
  std::erase_if(cases, [&](const BenchCase& each) { return each.size != size || each.scene.name != "hall"; });
  return cases;
}

TEST(ParetoSuite, HasEveryTechniqueAgainstTheSameReference) {
  for (const std::string& effect : effectNames()) {
    std::set<std::string> techniques;
    std::set<int> samples;
    std::set<float> budgets;
    for (const BenchCase& each : competing({1920, 1080}, effect)) {
      techniques.insert(each.technique);
      if (each.technique == kFullTechnique) samples.insert(each.samples);
      if (each.technique == kMresTechnique) budgets.insert(each.errorBudget);
      EXPECT_EQ(referenceSamplesOf(each), effect == "ssao" ? 64 : effect == "ssm" ? 196 : 228);
    }
    std::vector<std::string> expected = techniqueNames();
    if (effect == "ssm") std::erase(expected, kMinMaxTechnique);  // it has no use for geometry's edges
    EXPECT_THAT(techniques, UnorderedElementsAreArray(expected)) << effect;
    EXPECT_EQ(budgets.size(), 5U) << effect;
    EXPECT_EQ(samples.size(), 4U) << effect;
    EXPECT_FALSE(samples.contains(effect == "ssao" ? 64 : effect == "ssm" ? 196 : 228));
  }
}

TEST(ParetoSuite, HasItsCompetitorsInEverySceneAndSize) {
  std::set<std::tuple<std::string, std::string, int>> pictures;
  for (const BenchCase& each : suiteCases({"pareto"}))
    if (each.technique == "half-joint") pictures.emplace(each.scene.name, each.effect, each.size.x);
  EXPECT_EQ(pictures.size(), 3U * 3 * 3);
  EXPECT_EQ(referenceSamplesOf(competing(k4k, "ssgi").front()), 288);
}

TEST(ParetoSuite, ChecksTruthAndFlickerInOneSize) {
  std::set<std::string> checked;
  for (const BenchCase& each : suiteCases({"pareto"})) {
    EXPECT_EQ(each.truth, each.frames > 0) << nameOf(each);
    if (!each.truth) continue;
    EXPECT_EQ(each.size, glm::ivec2(1920, 1080)) << nameOf(each);
    checked.insert(each.technique);
  }
  EXPECT_THAT(checked, testing::IsSupersetOf({"mres", "half-joint", "quarter-joint", "checkerboard"}));
}

TEST(ParetoSuite, FitsItsHour) {
  EXPECT_LT(seconds(suiteCases({"pareto"}), paretoPlan()), 60 * 60.0) << "if no ratio ever got certain";
}

TEST(ParetoSuite, WhenThoroughHasEveryViewByEveryTechniqueInEverySize) {
  // 21 techniques and settings; of soft shadows all but min/max mips.
  EXPECT_EQ(casesOf("ssao", {"pareto", {}, true}).size(), 21U * 3 * 8 * 3);
  EXPECT_EQ(casesOf("ssm", {"pareto", {}, true}).size(), 20U * 3 * 8 * 3);
}

RepeatPlan onePair() {
  RepeatPlan plan = campaignPlan();
  plan.pairs = 1;
  return plan;
}

TEST(Plan, ExpectsRivalsToTakeTheirOwnTime) {
  BenchCase rival{{}, "ssgi", 288, k4k};
  rival.technique = "quarter-joint";
  const double quarter = secondsOf(rival, onePair());
  rival.technique = "interleaved";
  EXPECT_GT(secondsOf(rival, onePair()), quarter + 20.0);
  rival.frames = 4;
  EXPECT_GT(secondsOf(rival, onePair()), quarter + 100.0);
}

TEST(Plan, ExpectsOnePairOfTheSlowestPictures) {
  const BenchCase slow{{}, "ssgi", 4224, k4k};
  const BenchCase fast{{}, "ssao", 64, {1280, 720}};
  EXPECT_DOUBLE_EQ(secondsOf(slow, campaignPlan()), secondsOf(slow, onePair()));
  EXPECT_GT(secondsOf(fast, campaignPlan()), secondsOf(fast, onePair()) + campaignPlan().maxSeconds - 0.5);
}

TEST(Plan, ExpectsTheReferenceToWarmUpOnlyWhereThatIsShort) {
  const BenchCase slow{{}, "ssgi", 4224, k4k};
  const BenchCase fast{{}, "ssao", 64, {1280, 720}};
  RepeatPlan patient = onePair();
  patient.maxSecondsOfWarmUp = 1e9;
  EXPECT_GT(secondsOf(slow, patient), secondsOf(slow, onePair()) + 10.0);
  EXPECT_DOUBLE_EQ(secondsOf(fast, patient), secondsOf(fast, onePair()));
}

TEST(Plan, ExpectsTruthToTakeItsTime) {
  BenchCase benchCase{{}, "ssao", 64, {1920, 1080}};
  const double without = secondsOf(benchCase, campaignPlan());
  benchCase.truth = true;
  EXPECT_GT(secondsOf(benchCase, campaignPlan()), without + 2.0);
}

TEST(Plan, ExpectsWhatWasAskedFor) {
  const BenchCase benchCase{{}, "ssao", 64, k4k};
  RepeatPlan plan = campaignPlan();
  plan.pairs = 10;
  const double ten = secondsOf(benchCase, plan);
  plan.pairs = 20;
  EXPECT_GT(secondsOf(benchCase, plan), 1.5 * ten);
}

}  // namespace
}  // namespace host
