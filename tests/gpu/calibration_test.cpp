// What calibrate() measures decides which plan renders.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
  const Costs costs = multiResolution_.calibrate(effect, gbuffer_.frame());
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
  const Costs costs = multiResolution_.calibrate(effect, gbuffer_.frame());
  EXPECT_LT(costs.levels(), costs.plain());
  EXPECT_GT(costs.work, 1.0 / 64.0);
  EXPECT_LT(costs.work, 0.5);
  static_cast<void>(mixed(effect, gbuffer_.frame()));
  EXPECT_EQ(multiResolution_.report().technique, Technique::multiResolution);
  EXPECT_EQ(multiResolution_.report().plan.reason, "levels are faster");
}

TEST_F(Calibration, DecidesNothingThatWasAskedFor) {
  TestEffect effect(cheap());
  multiResolution_.calibrate(effect, gbuffer_.frame());
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
  multiResolution_.calibrate(first, gbuffer_.frame());
  static_cast<void>(mixed(second, gbuffer_.frame()));
  EXPECT_EQ(multiResolution_.report().technique, Technique::multiResolution);
  EXPECT_FALSE(multiResolution_.report().plan.costs);
}

TEST_F(Calibration, CostsCanBeKeptAndForgotten) {
  TestEffect effect(cheap());
  const Costs costs = multiResolution_.calibrate(effect, gbuffer_.frame());
  MultiResolution another;
  another.setCosts(effect, costs);
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
  const Costs plain = multiResolution_.calibrate(effect, gbuffer_.frame());
  Costs levels = plain;
  levels.overhead = 0.0;
  const auto alternate = [&] {
    for (const Costs& costs : {plain, levels}) {
      multiResolution_.setCosts(effect, costs);
      multiResolution_.render(effect, gbuffer_.frame());
    }
  };
  alternate();
  const std::size_t bytes = multiResolution_.report().bytes;
  const AllocationCounter allocations;
  alternate();
  EXPECT_EQ(allocations.count(), 0u);
  EXPECT_EQ(multiResolution_.report().bytes, bytes);
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
