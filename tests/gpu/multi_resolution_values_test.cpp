// What may get into pictures: nothing undefined, nothing that is no number, and constants as they are.
#include <gmock/gmock.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "effects/ssao/ssao.h"
#include "mres/mres.h"
#include "tests/gpu/multi_resolution_support.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

TEST_F(MultiResolutionTest, NothingUndefinedIsEverComposited) {
  for (const glm::ivec2 size : {glm::ivec2(97, 61), glm::ivec2(64, 64), glm::ivec2(33, 17)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), room());
    for (unsigned levels = 1; levels < 16; levels += 2) {
      Ssao ssao(ssaoWith(levels, 4));
      for (const float budget : {0.0f, 0.0025f}) {
        multiResolution_.settings().mask.errorBudget = budget;
        const Picture clean = mixed(ssao, gbuffer.frame());
        ASSERT_TRUE(isFinite(clean));
        for (const float poison : {kNan, -60000.0f, 60000.0f}) {
          multiResolution_.fillTargets(poison);
          ASSERT_EQ(mixed(ssao, gbuffer.frame()), clean)
              << size.x << "x" << size.y << ", levels " << levels << ", poison " << poison;
        }
      }
    }
  }
}

TEST_F(MultiResolutionTest, NothingUndefinedIsEverCompositedOfColoursAndUnfilteredEffects) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const char* body = "return vec4(fract(surface.position), 1.0);";
  TestEffect filtered({.body = body, .channels = 3, .filtered = true, .name = "filtered"});
  TestEffect unfiltered({.body = body, .channels = 3, .name = "unfiltered"});
  TestEffect single({.body = body, .name = "single"});
  for (TestEffect* effect : {&filtered, &unfiltered, &single}) {
    const Picture clean = mixed(*effect, gbuffer.frame());
    multiResolution_.fillTargets(kNan);
    EXPECT_EQ(mixed(*effect, gbuffer.frame()), clean);
    EXPECT_TRUE(isFinite(clean));
  }
}

TEST_F(MultiResolutionTest, AConstantGivesTheSameConstantAtEverySize) {
  constexpr float kValue = 0.37f;
  std::optional<float> stored;  // as the driver rounds it to a half
  std::vector<std::unique_ptr<TestEffect>> effects;
  for (const int channels : {1, 3}) {
    for (const bool filtered : {false, true}) {
      effects.push_back(std::make_unique<TestEffect>(TestEffect::Recipe{
          .body = "return vec4(0.37);",
          .channels = channels,
          .filtered = filtered,
          .background = glm::vec4(kValue),
          .name = std::string(filtered ? "filtered" : "plain") + std::to_string(channels)}));
    }
  }
  for (const glm::ivec2 size :
       {glm::ivec2(1), glm::ivec2(1, 4096), glm::ivec2(4096, 1), glm::ivec2(2, 3), glm::ivec2(7, 5),
        glm::ivec2(15), glm::ivec2(16), glm::ivec2(31, 17), glm::ivec2(127, 61), glm::ivec2(251, 257)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), room());
    for (const auto& effect : effects) {
      std::vector<Picture> pictures{full(*effect, gbuffer.frame())};
      for (const float budget : {0.0f, MaskSettings{}.errorBudget}) {
        multiResolution_.settings().mask.errorBudget = budget;
        pictures.push_back(mixed(*effect, gbuffer.frame()));
      }
      for (const Picture& picture : pictures) {
        stored = stored.value_or(picture.front());
        ASSERT_NEAR(*stored, kValue, kValue / 1024.0f);
        ASSERT_THAT(picture, testing::Each(*stored))
            << effect->description().name << " at " << size.x << "x" << size.y;
      }
    }
  }
}

/// 0.25, but for some pixels that have `bad` in one of the channels that count.
std::string mostlyGood(const char* bad, int channels) {
  return std::string("float zero = surface.pixel.x * 0.0;\n") +
         "bool isBad = surface.levelPixel.x % 5 == 2 && surface.levelPixel.y % 3 == 1;\n"
         "vec4 value = vec4(0.25);\n"
         "if (isBad) value." +
         (channels == 1 ? "r" : "b") + " = " + bad + ";\nreturn value;";
}

TEST_F(MultiResolutionTest, ValuesThatAreNoNumbersBecomeTheBackgroundAndSpreadNowhere) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  for (const char* bad : {"0.0 / zero", "1.0 / zero", "-1.0 / zero", "sqrt(zero - 1.0)"}) {
    for (const int channels : {1, 3}) {
      for (const bool filtered : {false, true}) {
        TestEffect effect({.body = mostlyGood(bad, channels),
                           .channels = channels,
                           .filtered = filtered,
                           .background = glm::vec4(0.25f)});
        multiResolution_.forget("test");
        EXPECT_THAT(mixed(effect, gbuffer.frame()), testing::Each(0.25f)) << bad << ", " << channels;
        EXPECT_THAT(full(effect, gbuffer.frame()), testing::Each(0.25f)) << bad << ", " << channels;
      }
    }
  }
}

TEST_F(MultiResolutionTest, ValuesBeyondTheRangeOfHalfFloatsEndWithIt) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), plane({0.1, 0.1, 1.0}, -5.0));
  TestEffect effect({.body = "return vec4(surface.pixel.x < 48.0 ? 1e30 : -70000.0);", .filtered = true});
  EXPECT_TRUE(isFinite(full(effect, gbuffer.frame())));
  EXPECT_TRUE(isFinite(mixed(effect, gbuffer.frame())));
}

}  // namespace
}  // namespace mres::test
