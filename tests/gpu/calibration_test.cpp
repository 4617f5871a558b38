// What calibrate() measures decides which plan renders.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "effects/ssao/ssao.h"
#include "tests/gpu/multi_resolution_support.h"
#include "tests/support/allocations.h"
#include "tests/support/gl_state.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

using testing::Contains;
using testing::Field;

/// What no machine renders faster by levels: a constant.
TestEffect::Recipe cheap() {
  return {.body = "return vec4(0.5);"};
}

/// What every machine does: thousands of steps a pixel of something flat.
TestEffect::Recipe dear() {
  return {.body =
              "float sum = 0.0;"
              "for (int i = 0; i < 20000; ++i) sum = sin(sum + surface.depth);"
              "return vec4(0.5 + 1e-9 * sum);",
          .name = "dear"};
}

class Calibration : public MultiResolutionTest {
 protected:
  const glm::ivec2 size_{256, 192};
  const SyntheticGBuffer gbuffer_{size_, perspective(size_), room()};
};

TEST_F(Calibration, FallsBackWhereThePlainEffectIsFaster) {
  TestEffect effect(cheap());
  const Costs costs = multiResolution_.calibrate(effect, gbuffer_.frame()).value();
  EXPECT_GT(costs.levels(), costs.plain());
  const Picture picture = mixed(effect, gbuffer_.frame());
  const Report& report = multiResolution_.report();
  EXPECT_EQ(report.technique, Technique::full);
  EXPECT_TRUE(report.plan.fallsBack);
  EXPECT_EQ(report.plan.reason, "the plain effect is faster");
  ASSERT_TRUE(report.plan.costs);
  EXPECT_EQ(report.plan.costs->plain(), costs.plain());
  EXPECT_THAT(report.skipped, Contains(Field(&Skip::reason, "the plain effect is faster here")).Times(3));
  EXPECT_EQ(picture, full(effect, gbuffer_.frame()));
}

TEST_F(Calibration, KeepsLevelsWhereTheseAreFaster) {
  TestEffect effect(dear());
  const Costs costs = multiResolution_.calibrate(effect, gbuffer_.frame()).value();
  EXPECT_LT(costs.levels(), costs.plain());
  EXPECT_GT(costs.work, 1.0 / 64.0);
  EXPECT_LT(costs.work, 0.5);
  static_cast<void>(mixed(effect, gbuffer_.frame()));
  EXPECT_EQ(multiResolution_.report().technique, Technique::multiResolution);
  EXPECT_EQ(multiResolution_.report().plan.reason, "levels are faster");
}

TEST_F(Calibration, DecidesNothingThatWasAskedFor) {
  TestEffect effect(cheap());
  multiResolution_.setCosts(effect, Costs{.overhead = 1.0});
  multiResolution_.settings().plan.fallBack = false;
  static_cast<void>(mixed(effect, gbuffer_.frame()));
  EXPECT_EQ(multiResolution_.report().technique, Technique::multiResolution);
  multiResolution_.settings() = {};
  multiResolution_.settings().technique = Technique::paper;
  multiResolution_.render(effect, gbuffer_.frame());
  EXPECT_EQ(multiResolution_.report().technique, Technique::paper);
}

TEST_F(Calibration, OfOneEffectIsNotThatOfAnother) {
  TestEffect first(cheap());
  TestEffect second(dear());
  multiResolution_.setCosts(first, Costs{.overhead = 1.0});
  static_cast<void>(mixed(second, gbuffer_.frame()));
  EXPECT_EQ(multiResolution_.report().technique, Technique::multiResolution);
  EXPECT_FALSE(multiResolution_.report().plan.costs);
}

TEST_F(Calibration, CostsCanBeKeptAndForgotten) {
  TestEffect effect(cheap());
  constexpr Costs kCosts{.overhead = 1.0};
  MultiResolution another;
  another.setCosts(effect, kCosts);
  another.render(effect, gbuffer_.frame());
  EXPECT_EQ(another.report().technique, Technique::full);
  another.setCosts(effect, std::nullopt);
  another.render(effect, gbuffer_.frame());
  EXPECT_EQ(another.report().technique, Technique::multiResolution);
}

TEST_F(Calibration, LeavesTheProfilerAndTheHostsStateAsTheyWere) {
  TestEffect effect(cheap());
  const GlState before = captureGlState();
  static_cast<void>(multiResolution_.calibrate(effect, gbuffer_.frame()));
  EXPECT_THAT(differences(before, captureGlState()), testing::IsEmpty());
  static_cast<void>(mixed(effect, gbuffer_.frame()));
  EXPECT_TRUE(multiResolution_.report().stages.empty()) << "profiling is off";
}

TEST_F(Calibration, ThrowsForWhatCannotBeRenderedAndLeavesProfilingOff) {
  TestEffect effect(cheap());
  Frame frame = gbuffer_.frame();
  frame.depth = 0;
  EXPECT_THROW(multiResolution_.calibrate(effect, frame), std::invalid_argument);
  static_cast<void>(mixed(effect, gbuffer_.frame()));
  EXPECT_TRUE(multiResolution_.report().stages.empty());
}

TEST_F(Calibration, ChangingThePlanAllocatesNothing) {
  TestEffect effect(cheap());
  const auto alternate = [&] {
    for (const bool levels : {false, true}) {
      multiResolution_.setCosts(effect, levels ? Costs{.evaluation = 1.0} : Costs{.overhead = 1.0});
      multiResolution_.render(effect, gbuffer_.frame());
      EXPECT_EQ(multiResolution_.report().plan.fallsBack, !levels);
    }
  };
  for (int i = 0; i < 2; ++i) alternate();  // drivers compile variants of shaders
  const std::size_t bytes = multiResolution_.report().bytes;
  const AllocationCounter allocations;
  alternate();
  EXPECT_EQ(allocations.count(), 0u);
  EXPECT_EQ(multiResolution_.report().bytes, bytes);
}

TEST_F(Calibration, OfWhatIsTheSameEverywhereThereIsNone) {
  Ssao ssao({.intensity = 0.0f});
  EXPECT_FALSE(multiResolution_.calibrate(ssao, gbuffer_.frame()));
  static_cast<void>(mixed(ssao, gbuffer_.frame()));
  EXPECT_FALSE(multiResolution_.report().plan.fallsBack);
  EXPECT_FALSE(multiResolution_.report().plan.costs);
  EXPECT_EQ(multiResolution_.report().plan.reason, "an intensity of 0 shows nothing");
}

TEST_F(Calibration, FramesTeachTheCostsOfTheirOwnEffectAlone) {
  MultiResolution multiResolution({.profiling = gl::Profiler::Mode::query, .measureCoverage = true});
  TestEffect first(cheap());
  TestEffect second(dear());
  TestEffect third({.body = "return vec4(0.25);", .name = "third"});
  for (int frame = 0; frame < 12; ++frame) {
    for (TestEffect* effect : {&first, &second, &third}) {
      multiResolution.settings().technique = effect == &third ? Technique::paper : Technique::multiResolution;
      multiResolution.render(*effect, gbuffer_.frame());
      glFinish();
      const std::optional<Costs>& costs = multiResolution.report().plan.costs;
      if (effect == &third) {
        EXPECT_FALSE(costs) << "by the paper's technique nothing is chosen";
      }
      if (costs) {
        // Of a constant, the half level finds out that nothing is to be refined; so does the other.
        EXPECT_GT(costs->work, 1.0 / 64.0);
        EXPECT_LT(costs->work, 0.5);
      }
    }
  }
  multiResolution.settings().technique = Technique::multiResolution;
  multiResolution.render(first, gbuffer_.frame());
  EXPECT_TRUE(multiResolution.report().plan.costs);
  multiResolution.render(second, gbuffer_.frame());
  EXPECT_TRUE(multiResolution.report().plan.costs);
  multiResolution.forget("test");
  for (int frame = 0; frame < 6; ++frame) multiResolution.render(second, gbuffer_.frame());
}

TEST_F(Calibration, LevelsAfterAPlainFrameDrawWhatTheyDrewBefore) {
  TestEffect effect(levelNumbers());
  const Picture before = mixed(effect, gbuffer_.frame());
  multiResolution_.setCosts(effect, Costs{.overhead = 1.0});
  multiResolution_.fillTargets(kNan);
  const Picture plain = mixed(effect, gbuffer_.frame());
  EXPECT_EQ(plain, full(effect, gbuffer_.frame()));
  multiResolution_.setCosts(effect, std::nullopt);
  multiResolution_.fillTargets(kNan);
  EXPECT_EQ(mixed(effect, gbuffer_.frame()), before);
}

}  // namespace
}  // namespace mres::test
