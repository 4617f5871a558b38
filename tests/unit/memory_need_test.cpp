#include "host/console/memory_need.h"

#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>
#include <sys/resource.h>

namespace host {
namespace {

constexpr std::uint64_t kGibibyte = 1U << 30U;

PictureNeed needOfPixels(glm::ivec2 size) {
  return needOf({}, size);
}

TEST(MemoryNeed, GrowsWithThePixels) {
  const PictureNeed small = needOfPixels({1920, 1080});
  const PictureNeed large = needOfPixels({3840, 2160});
  EXPECT_LT(bytesOfRender(small), bytesOfRender(large));
  EXPECT_LT(bytesOfRender(large), bytesOfComparison(large));
  EXPECT_LT(bytesOfComparison(large), bytesOfComparisonWithTruth(large));
  EXPECT_LT(bytesOfComparison(large), 2 * kGibibyte) << "of the demo";
  EXPECT_GT(bytesOfRender(needOfPixels({16384, 16384})), 16 * kGibibyte);
}

TEST(MemoryNeed, GrowsWithTheChannelsOfTheEffect) {
  PictureSettings settings;
  const std::uint64_t ofOne = bytesOfComparison(needOf(settings, {3840, 2160}));
  settings.effect = kSsgiEffect;
  EXPECT_GT(bytesOfComparison(needOf(settings, {3840, 2160})), ofOne + kGibibyte / 4);
}

TEST(MemoryNeed, GrowsWithTheShadowMap) {
  PictureSettings settings;
  settings.renderer.shadowMapSize = 1;
  const std::uint64_t withoutMap = bytesOfRender(needOf(settings, {64, 64}));
  settings.renderer.shadowMapSize = 16384;
  EXPECT_EQ(bytesOfRender(needOf(settings, {64, 64})), withoutMap - 4 + kGibibyte);
}

TEST(MemoryNeed, MoreThanThereIsIsOneSentence) {
  EXPECT_GT(availableMemory(), kGibibyte / 4);
  requireMemory(kGibibyte, kGibibyte, "");
  try {
    requireMemory(20 * kGibibyte, 16 * kGibibyte, "wait for more");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("20.0 GiB"), testing::HasSubstr("16.0 GiB"),
                                             testing::EndsWith("; wait for more.")));
  }
}

TEST(MemoryNeed, HeedsTheLimitOfTheProcess) {
  const auto isLimited = [] {
    const rlimit limit{kGibibyte, kGibibyte};
    return setrlimit(RLIMIT_AS, &limit) == 0 && availableMemory() == kGibibyte;
  };
  EXPECT_EXIT(std::_Exit(isLimited() ? 0 : 1), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace host
