#include "mres/plan/plan_chooser.h"

#include <gtest/gtest.h>

namespace mres {
namespace {

constexpr double kPixels = 1e6;  // so that a millisecond is a nanosecond per pixel

/// By levels: half of the pixels evaluated, at 1 ms for all of them, inputs of 0.1 ms.
FrameCost byLevels(double overheadMs) {
  return {.sharedMs = 0.1, .overheadMs = overheadMs, .evaluationMs = 0.5, .byLevels = true};
}

constexpr double kWork = 0.5;
constexpr FrameCost kCheapLevels{.sharedMs = 0.1, .overheadMs = 0.1, .evaluationMs = 0.5, .byLevels = true};
constexpr FrameCost kDearLevels{.sharedMs = 0.1, .overheadMs = 0.9, .evaluationMs = 0.5, .byLevels = true};
constexpr FrameCost kPlain{.sharedMs = 0.1, .evaluationMs = 1.0};

void observe(PlanChooser& chooser, const FrameCost& frame, int times) {
  for (int i = 0; i < times; ++i) chooser.observe(frame, kWork, kPixels);
}

/// In which the plain effect has taken over.
PlanChooser fallenBack() {
  PlanChooser chooser;
  observe(chooser, kDearLevels, PlanChooser::kFramesToChange);
  return chooser;
}

TEST(PlanChooser, RendersLevelsWhileNothingIsKnown) {
  PlanChooser chooser;
  EXPECT_TRUE(chooser.choosesLevels());
  EXPECT_FALSE(chooser.costs());
  observe(chooser, kPlain, 1000);
  EXPECT_TRUE(chooser.choosesLevels()) << "of levels, nothing is known";
}

TEST(PlanChooser, TakesTheFasterOneOfMeasuredCostsAtOnce) {
  PlanChooser chooser;
  const Costs costs{.shared = 1.0, .overhead = 2.0, .evaluation = 10.0, .work = 0.5};
  chooser.setCosts(costs);
  EXPECT_TRUE(chooser.choosesLevels()) << "8 ns instead of 11";
  Costs scattered = costs;
  scattered.scatter = 2.0;
  chooser.setCosts(scattered);
  EXPECT_FALSE(chooser.choosesLevels()) << "8 ns instead of 6";
  chooser.setCosts(std::nullopt);
  EXPECT_TRUE(chooser.choosesLevels());
  EXPECT_FALSE(chooser.costs());
}

TEST(PlanChooser, LearnsCostsFromFrames) {
  PlanChooser chooser;
  observe(chooser, byLevels(0.2), 3);
  ASSERT_TRUE(chooser.costs());
  EXPECT_NEAR(chooser.costs()->levels(), 0.8, 1e-12);
  EXPECT_NEAR(chooser.costs()->plain(), 1.1, 1e-12);
  observe(chooser, byLevels(0.4), 200);
  EXPECT_NEAR(chooser.costs()->levels(), 1.0, 1e-3) << "the last frames count";
}

TEST(PlanChooser, FallsBackOnlyAfterSeveralFramesInARow) {
  PlanChooser chooser;
  observe(chooser, kDearLevels, PlanChooser::kFramesToChange - 1);
  EXPECT_TRUE(chooser.choosesLevels());
  observe(chooser, kDearLevels, 1);
  EXPECT_FALSE(chooser.choosesLevels());
}

TEST(PlanChooser, ASingleSlowFrameChangesNothing) {
  PlanChooser chooser;
  observe(chooser, kCheapLevels, 50);
  for (int i = 0; i < 20; ++i) {
    observe(chooser, byLevels(3.0), 1);
    observe(chooser, kCheapLevels, 20);
    EXPECT_TRUE(chooser.choosesLevels()) << i;
  }
}

TEST(PlanChooser, NeverWaversWhereBothAreAboutAsFast) {
  PlanChooser chooser;
  int changes = 0;
  for (int i = 0; i < PlanChooser::kFramesToRetry; ++i) {
    const bool levels = chooser.choosesLevels();
    const double noise = i % 2 == 0 ? 1.02 : 0.98;
    observe(chooser, levels ? byLevels(0.5 * noise) : FrameCost{.sharedMs = 0.1, .evaluationMs = noise}, 1);
    changes += chooser.choosesLevels() != levels ? 1 : 0;
  }
  EXPECT_EQ(changes, 0);
}

TEST(PlanChooser, FramesOfBeforeAChangeCountForNothing) {
  PlanChooser chooser = fallenBack();
  const double plain = chooser.costs()->plain();
  observe(chooser, byLevels(100.0), 20);  // their times came late
  EXPECT_EQ(chooser.costs()->plain(), plain);
  EXPECT_FALSE(chooser.choosesLevels());
}

TEST(PlanChooser, ComesBackWhenTheEffectGrowsDearer) {
  PlanChooser chooser = fallenBack();
  observe(chooser, {.sharedMs = 0.1, .evaluationMs = 10.0}, PlanChooser::kFramesToChange);
  EXPECT_TRUE(chooser.choosesLevels()) << "levels: 0.1 + 0.9 + 5 ms, plain: 10.1 ms";
}

TEST(PlanChooser, TriesLevelsAgainLessAndLessOften) {
  PlanChooser chooser = fallenBack();
  for (const int pause : {PlanChooser::kFramesToRetry, 2 * PlanChooser::kFramesToRetry}) {
    observe(chooser, kPlain, pause - 1);
    EXPECT_FALSE(chooser.choosesLevels());
    observe(chooser, kPlain, 1);
    EXPECT_TRUE(chooser.choosesLevels()) << "after " << pause;
    observe(chooser, kDearLevels, PlanChooser::kFramesToChange);
    EXPECT_FALSE(chooser.choosesLevels());
  }
}

TEST(PlanChooser, ATryThatPaidMakesTheNextPauseShortAgain) {
  PlanChooser chooser = fallenBack();
  for (int i = 0; i < 3; ++i) {
    observe(chooser, kPlain, PlanChooser::kFramesToRetry);
    EXPECT_TRUE(chooser.choosesLevels()) << i;
    observe(chooser, kCheapLevels, 100);
    observe(chooser, kDearLevels, 100);
    EXPECT_FALSE(chooser.choosesLevels()) << i;
  }
}

TEST(PlanChooser, ATryThatPaysStays) {
  PlanChooser chooser = fallenBack();
  observe(chooser, kPlain, PlanChooser::kFramesToRetry);
  observe(chooser, kCheapLevels, 100);
  EXPECT_TRUE(chooser.choosesLevels());
}

TEST(FrameCost, SortsStagesByWhatNeedsThem) {
  const FrameCost levels = frameCost({{"mres.depth", 1.0},
                                      {"mres.inputs", 2.0},
                                      {"mres.edges", 4.0},
                                      {"mres.level3", 8.0},
                                      {"mres.filter", 16.0},
                                      {"mres.composite", 32.0},
                                      {"mres.stencil", 64.0},
                                      {"mres.upsample", 128.0}});
  EXPECT_TRUE(levels.byLevels);
  EXPECT_EQ(levels.sharedMs, 3.0);
  EXPECT_EQ(levels.evaluationMs, 56.0);
  EXPECT_EQ(levels.overheadMs, 196.0);
  EXPECT_EQ(levels.totalMs(), 255.0);
  EXPECT_FALSE(frameCost({{"mres.depth", 1.0}, {"mres.level0", 8.0}, {"mres.composite", 1.0}}).byLevels);
}

}  // namespace
}  // namespace mres
