#include "host/commands/memory_need.h"

#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>
#include <sys/resource.h>

namespace host {
namespace {

constexpr std::uint64_t kGibibyte = 1U << 30U;

TEST(MemoryNeed, GrowsWithThePixels) {
  EXPECT_LT(bytesOfRender({1920, 1080}), bytesOfRender({3840, 2160}));
  EXPECT_LT(bytesOfRender({3840, 2160}), bytesOfComparison({3840, 2160}));
  EXPECT_LT(bytesOfComparison({3840, 2160}), 2 * kGibibyte) << "of the demo";
  EXPECT_GT(bytesOfRender({16384, 16384}), 16 * kGibibyte);
}

TEST(MemoryNeed, MoreThanThereIsIsOneSentence) {
  EXPECT_GT(availableMemory(), kGibibyte / 4);
  requireMemory(kGibibyte, kGibibyte);
  try {
    requireMemory(20 * kGibibyte, 16 * kGibibyte);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("20.0 GiB"), testing::HasSubstr("16.0 GiB"),
                                             testing::HasSubstr("smaller --size")));
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
