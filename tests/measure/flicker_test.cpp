// Flicker of pictures that the host's renderer draws.
#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/measure/comparison.h"
#include "host/platform/gl_context.h"

namespace host {
namespace {

constexpr glm::ivec2 kSize(160, 90);
constexpr CameraPath kStandstill{.frames = 3, .metres = 0.0f, .degrees = 0.0f};

class Flicker : public testing::Test {
 protected:
  static PictureSettings settingsOf(const std::string& effect, const std::string& technique) {
    PictureSettings settings;
    settings.effect = effect;
    settings.technique = technique;
    settings.ssao.samples = 16;
    settings.softShadows.samples = 16;
    settings.ssgi.samples = 16;
    return settings;
  }
  Measurement measure(const std::string& effect, const std::string& technique,
                      std::optional<CameraPath> path) {
    Comparison comparison(scene_, settingsOf(effect, technique), true);
    return comparison.measure({.size = kSize, .path = path});
  }

  GlContext context_;
  Scene scene_ = loadScene("breakfast");
};

TEST_F(Flicker, OfTheReferenceIsNone) {
  for (const std::string& effect : effectNames()) {
    const TemporalErrors errors = measure(effect, kFullTechnique, CameraPath{.frames = 3}).temporal.value();
    EXPECT_EQ(errors.frames, 3) << effect;
    EXPECT_EQ(errors.rms, 0.0) << effect;
    EXPECT_EQ(errors.blockMax, 0.0) << effect;
    EXPECT_EQ(errors.nonFinite, 0) << effect;
    EXPECT_GT(errors.referenceChange, 0.0) << effect;
  }
}

TEST_F(Flicker, IsNoneWhereNothingMoves) {
  for (const std::string& effect : effectNames()) {
    const Measurement still = measure(effect, kMresTechnique, kStandstill);
    EXPECT_GT(still.error.value().rms, 0.0) << effect;
    EXPECT_EQ(still.temporal.value().max, 0.0) << effect;
    EXPECT_EQ(still.temporal.value().techniqueChange, 0.0) << effect;
    EXPECT_EQ(still.temporal.value().referenceChange, 0.0) << effect;
  }
}

/// Two independent errors differ by no more than the root of two times their RMS; half as much again for
/// frames that are harder than the first.
TEST_F(Flicker, AlongAPathIsSomeButNoMoreThanTheErrorAllows) {
  for (const std::string& effect : effectNames()) {
    const Measurement moving = measure(effect, kMresTechnique, CameraPath{.frames = 4});
    const TemporalErrors errors = moving.temporal.value();
    EXPECT_GT(errors.rms, 0.0) << effect;
    EXPECT_LT(errors.rms, 1.5 * std::sqrt(2.0) * moving.error.value().rms) << effect;
    EXPECT_LE(errors.rms, errors.blockMax) << effect;
    EXPECT_LE(errors.blockPercentile99, errors.blockMax) << effect;
    EXPECT_LE(errors.blockMax, errors.max) << effect;
  }
}

TEST_F(Flicker, LeavesTheViewItselfForPictures) {
  const PictureSettings settings = settingsOf("ssm", kMresTechnique);
  Comparison comparison(scene_, settings, true);
  const Measurement still = comparison.measure({.size = kSize});
  const ComparisonPictures before = comparison.pictures();
  const Measurement moved = comparison.measure({.size = kSize, .path = CameraPath{.frames = 3}});
  const ComparisonPictures after = comparison.pictures();
  EXPECT_FALSE(still.temporal.has_value());
  EXPECT_EQ(moved.error.value().rms, still.error.value().rms);
  EXPECT_EQ(moved.coverage, still.coverage);
  EXPECT_EQ(after.technique.pixels, before.technique.pixels);
  EXPECT_EQ(after.techniqueEffect.pixels, before.techniqueEffect.pixels);
}

TEST_F(Flicker, TellsHowFarItIs) {
  std::vector<double> shares;
  std::vector<std::string> steps;
  Comparison comparison(scene_, settingsOf("ssao", kMresTechnique), true);
  comparison.measure({.size = kSize, .path = CameraPath{.frames = 2}},
                     [&](double share, const std::string& what) {
                       shares.push_back(share);
                       steps.push_back(what);
                     });
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_THAT(steps, testing::IsSupersetOf({"frame 1 of 2", "frame 2 of 2", "comparing the pictures"}));
}

}  // namespace
}  // namespace host
