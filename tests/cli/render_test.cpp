// `mres render`: its picture, and the times that are asked for.
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "host/image/image_file.h"
#include "tests/cli/command_support.h"

namespace host::test {
namespace {

using nlohmann::json;

TEST_F(Command, RenderWritesAPicture) {
  succeed({"render", scene_, "--size", "97x41", "-o", folder_ / "a.png"});
  const FloatImage picture = readImage(folder_ / "a.png");
  EXPECT_EQ(picture.size, glm::ivec2(97, 41));
  EXPECT_GT(std::ranges::max(picture.pixels), 0.1f);
}

TEST_F(Command, RenderWritesLinearRadianceAsExr) {
  succeed({"render", scene_, "--size", "97x41", "--effect", "none", "-o", folder_ / "a.exr"});
  EXPECT_EQ(readImage(folder_ / "a.exr").size, glm::ivec2(97, 41));
}

TEST_F(Command, RenderTakesEndingsInCapitals) {
  succeed({"render", scene_, "--size", "8x8", "-o", folder_ / "a.PNG"});
  EXPECT_EQ(readImage(folder_ / "a.PNG").size, glm::ivec2(8, 8));
}

TEST_F(Command, RenderOfOnePixel) {
  for (const char* technique : {"full", "mres"})
    succeed({"render", scene_, "--size", "1x1", "--technique", technique, "-o", folder_ / "a.png"});
}

TEST_F(Command, RenderIsTheSameEveryTime) {
  for (const char* name : {"a.exr", "b.exr"})
    succeed({"render", scene_, "--size", "64x36", "-o", folder_ / name});
  EXPECT_EQ(readImage(folder_ / "a.exr").pixels, readImage(folder_ / "b.exr").pixels);
}

TEST_F(Command, RenderTimesTheEffectAlone) {
  const json report = json::parse(
      succeed({"render", scene_, "--size", "64x36", "--repeat", "3", "--json", "-o", folder_ / "a.png"}));
  const json& result = report["results"][0];
  EXPECT_EQ(result["scene"], "corner");
  EXPECT_EQ(result["time_ms"]["runs"], 3);
  EXPECT_TRUE(result["speedup"].is_null());
  EXPECT_FALSE(result["stages_ms"].empty());
  EXPECT_FALSE(result["stages_clock"].is_null());
}

TEST_F(Command, RenderTimesUntilTheMedianIsKnown) {
  const json report =
      json::parse(succeed({"render", scene_, "--size", "64x36", "--json", "-o", folder_ / "a.png"}));
  EXPECT_GE(report["results"][0]["time_ms"]["runs"], 5);
}

TEST_F(Command, RenderTimesOnlyWhatIsAskedFor) {
  const std::string picture = folder_ / "a.png";
  EXPECT_EQ(succeed({"render", scene_, "--size", "64x36", "-o", picture}), picture + "\n");
  EXPECT_EQ(succeed({"render", scene_, "--size", "64x36", "--no-timing", "-o", picture}), picture + "\n");
  EXPECT_THAT(
      succeed({"render", scene_, "--size", "64x36", "--repeat", "2", "-o", picture}),
      testing::MatchesRegex(picture + "\nssao by mres: .* ms, the median of 2 runs from .* ms \\(.*\\)\n"));
}

TEST_F(Command, RenderWithoutTimingReportsAllElse) {
  const json report = json::parse(
      succeed({"render", scene_, "--size", "64x36", "--no-timing", "--json", "-o", folder_ / "a.png"}));
  const json& result = report["results"][0];
  EXPECT_TRUE(result["time_ms"].is_null());
  EXPECT_TRUE(result["stages_ms"].empty());
  EXPECT_TRUE(result["stages_clock"].is_null());
  EXPECT_EQ(result["coverage"].back(), 1.0);
  EXPECT_GT(result["gpu_bytes"], 0);
}

}  // namespace
}  // namespace host::test
