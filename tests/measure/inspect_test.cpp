#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "host/measure/effect_instance.h"
#include "host/platform/gl_context.h"

namespace host {
namespace {

constexpr glm::ivec2 kSize(160, 90);

class Inspect : public testing::Test {
 protected:
  Measurement inspected(StageClock clock, const std::string& technique = kMresTechnique) {
    Renderer renderer(scene_, profiler_);
    const mres::Frame frame = frameOf(renderer, renderer.drawGeometry(scene_.cameras[0], kSize), kSize);
    EffectInstance instance({}, technique, EffectInstance::Coverage::measured);
    Measurement measurement;
    inspect(instance, frame, clock, measurement);
    return measurement;
  }

  GlContext context_;
  mres::gl::Profiler profiler_;
  Scene scene_ = loadScene("office");
};

TEST_F(Inspect, TellsStagesByEitherClock) {
  const Measurement byFinish = inspected(StageClock::finish);
  const Measurement byQuery = inspected(StageClock::query);
  EXPECT_EQ(byFinish.stagesClock, "glFinish+steady_clock");
  EXPECT_EQ(byQuery.stagesClock, "GL_TIMESTAMP");
  ASSERT_FALSE(byFinish.stages.empty());
  ASSERT_EQ(byFinish.stages.size(), byQuery.stages.size());
  for (std::size_t i = 0; i < byFinish.stages.size(); ++i)
    EXPECT_EQ(byFinish.stages[i].name, byQuery.stages[i].name);
  EXPECT_EQ(byFinish.coverage, byQuery.coverage);
}

TEST_F(Inspect, WithoutAClockTellsAllElse) {
  const Measurement timed = inspected(StageClock::finish);
  const Measurement untimed = inspected(StageClock::off);
  EXPECT_TRUE(untimed.stages.empty());
  EXPECT_EQ(untimed.coverage, timed.coverage);
  EXPECT_LT(untimed.coverage.front(), 1.0);
  EXPECT_EQ(untimed.gpuBytes, timed.gpuBytes);
}

TEST_F(Inspect, TellsThePixelsAndTheStagesOfPeers) {
  const Measurement half = inspected(StageClock::finish, "half-joint");
  EXPECT_EQ(half.work, 0.25);
  EXPECT_TRUE(half.coverage.empty());
  EXPECT_THAT(half.stages, testing::Contains(testing::Field(&StageCost::name, "upsample")));
  EXPECT_GT(half.gpuBytes, 0u);
  const Measurement tiles = inspected(StageClock::off, "adaptive-tiles");
  EXPECT_GE(tiles.work, 1.0 / 16.0);
  EXPECT_LT(tiles.work, 1.0) << "counted";
  EXPECT_FALSE(inspected(StageClock::off).work.has_value()) << "coverage tells it";
}

TEST(StageClocks, AreQueriesOnlyWhereTheseAreTrue) {
  EXPECT_EQ(stageClockOf(true), StageClock::finish);
  EXPECT_EQ(stageClockOf(false), StageClock::query);
}

TEST_F(Inspect, LightsThatAreLeftOutAreAWarning) {
  Light lamp;
  lamp.type = LightType::point;
  scene_.lights.resize(67, lamp);
  scene_.warnings = {"A texture is missing."};
  const Renderer renderer(scene_, profiler_);
  EXPECT_THAT(warningsOf(scene_, renderer),
              testing::ElementsAre("A texture is missing.", testing::StartsWith("3 of its lights")));
}

}  // namespace
}  // namespace host
