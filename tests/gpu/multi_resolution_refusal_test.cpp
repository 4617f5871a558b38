// What the facade and the driver refuse, and that the facade stays usable.
#include <array>
#include <gmock/gmock.h>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "effects/ssao/ssao.h"
#include "mres/mres.h"
#include "tests/gpu/multi_resolution_support.h"
#include "tests/support/failing_framebuffers.h"
#include "tests/support/pictures.h"
#include "tests/support/sentences.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

TEST_F(MultiResolutionTest, RefusesASecondEffectOfTheSameNameUntilTheFirstIsForgotten) {
  const glm::ivec2 size(40, 30);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const TestEffect::Recipe recipe{.body = "return vec4(0.25);"};
  TestEffect first(recipe);
  TestEffect same(recipe);
  static_cast<void>(mixed(first, gbuffer.frame()));
  EXPECT_THAT(mixed(same, gbuffer.frame()), testing::Each(0.25f)) << "an equal one may share";

  std::vector<TestEffect::Recipe> others(4, recipe);
  others[0].body = "return vec4(0.5);";
  others[1].channels = 3;
  others[2].filtered = true;
  others[3].background = glm::vec4(0.5f);
  for (const TestEffect::Recipe& other : others) {
    TestEffect second(other);
    EXPECT_THAT([&] { multiResolution_.render(second, gbuffer.frame()); },
                refusesInASentence<std::logic_error>("named 'test'"));
  }
  multiResolution_.forget("test");
  TestEffect second(others[0]);
  EXPECT_THAT(mixed(second, gbuffer.frame()), testing::Each(0.5f));
}

/// Whether rendering the second frame after the first throws if the driver accepts only so many framebuffers.
bool isRejectedAfter(int good, MultiResolution& multiResolution, Effect& effect,
                     const std::array<Frame, 2>& frames) {
  multiResolution.render(effect, frames[0]);
  const FailingFramebuffers driver(good);
  try {
    multiResolution.render(effect, frames[1]);
  } catch (const std::runtime_error&) {
    return true;
  }
  return false;
}

TEST_F(MultiResolutionTest, ATargetThatTheDriverRejectsLeavesNothingHalfMade) {
  const glm::ivec2 size(97, 61);
  const glm::ivec2 otherSize(70, 50);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const SyntheticGBuffer other(otherSize, perspective(otherSize), room());
  Ssao ssao(ssaoWith(15, 1));
  const Picture expected = mixed(ssao, gbuffer.frame());
  int good = 0;
  while (isRejectedAfter(good, multiResolution_, ssao, {other.frame(), gbuffer.frame()})) {
    EXPECT_THAT([&] { multiResolution_.debugView(DebugView::levels); },
                refusesInASentence<std::logic_error>("call render() first"));
    ASSERT_EQ(mixed(ssao, gbuffer.frame()), expected) << "after " << good << " complete framebuffers";
    ++good;
  }
  EXPECT_GT(good, 20) << "targets, masks, zones and the pyramid were all made anew";
}

/// Every way to put one number of a settings struct out of its range.
template <class SomeSettings>
std::vector<SomeSettings> outOfRange(const SomeSettings& good) {
  std::vector<SomeSettings> bad;
  int count = 0;
  SomeSettings probe = good;
  visit(probe, [&](const char*, auto&, const SettingInfo&) { ++count; });
  for (int changed = 0; changed < count; ++changed) {
    for (const double beyond : {-0.01, 0.01, std::numeric_limits<double>::quiet_NaN()}) {
      SomeSettings settings = good;
      int index = 0;
      visit(settings, [&](const char*, auto& value, const SettingInfo& info) {
        using Value = std::remove_reference_t<decltype(value)>;
        constexpr bool kWhole = std::is_same_v<Value, bool> || std::is_enum_v<Value>;
        if (index++ != changed || kWhole) return;  // what is a little beyond is inside or no value of it
        value = static_cast<Value>((beyond < 0.0 ? info.min : info.max) + beyond);
        bad.push_back(settings);
      });
    }
  }
  return bad;
}

TEST_F(MultiResolutionTest, RefusesSettingsOutOfRangeAndStaysUsable) {
  const glm::ivec2 size(40, 30);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  TestEffect effect({.body = "return vec4(0.25);"});
  for (const MaskSettings& bad : outOfRange(MaskSettings{})) {
    multiResolution_.settings().mask = bad;
    EXPECT_THAT([&] { multiResolution_.render(effect, gbuffer.frame()); },
                refusesInASentence("MaskSettings::"));
  }
  multiResolution_.settings().mask = {.combination = static_cast<MaskCombination>(2)};
  EXPECT_THAT([&] { multiResolution_.render(effect, gbuffer.frame()); },
              refusesInASentence("MaskSettings::combination must be 0 to 1."));
  multiResolution_.settings().mask = {};
  for (const float bad : {-1.0f, 64.5f, kNan}) {
    LevelTable levels = kSsaoLevels;
    levels[1].maskVariance = bad;
    effect.setLevels(levels);
    EXPECT_THAT([&] { multiResolution_.render(effect, gbuffer.frame()); },
                refusesInASentence("LevelSettings::maskVariance must be 0 to 64 pixels^2."));
  }
  for (const int bad : {-1, 0, 5}) {
    LevelTable levels = kSsaoLevels;
    levels[3].noisePeriod = bad;
    effect.setLevels(levels);
    EXPECT_THAT([&] { multiResolution_.render(effect, gbuffer.frame()); },
                refusesInASentence("LevelSettings::noisePeriod must be 1 to 4 pixels."));
  }
  effect.setLevels(kSsaoLevels);
  EXPECT_THAT(mixed(effect, gbuffer.frame()), testing::Each(0.25f));
}

TEST_F(MultiResolutionTest, RefusesImpossibleFramesAndStaysUsable) {
  const glm::ivec2 size(40, 30);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  Ssao ssao(ssaoWith(15));
  const Picture before = mixed(ssao, gbuffer.frame());
  Frame bad = gbuffer.frame();
  bad.depth = 0;
  EXPECT_THROW(static_cast<void>(multiResolution_.render(ssao, bad)), std::invalid_argument);
  EXPECT_EQ(mixed(ssao, gbuffer.frame()), before);
}

}  // namespace
}  // namespace mres::test
