#include "host/truth/pixel_grid.h"

#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace host {
namespace {

TEST(PixelGrids, CountWhatLiesInside) {
  EXPECT_EQ((PixelGrid{{7, 5}}.size()), glm::ivec2(7, 5));
  EXPECT_EQ((PixelGrid{{7, 5}, 4, {1, 1}}.size()), glm::ivec2(7, 5));
  EXPECT_EQ((PixelGrid{{19, 18}, 1, {9, 9}}.size()), glm::ivec2(3, 2));
  EXPECT_EQ((PixelGrid{{40, 14}, 4, {5, 3}}.size()),
            glm::ivec2(8, 6));  // the last rows of a tile are cut off
  EXPECT_EQ((PixelGrid{{1, 1}, 4, {5, 3}}.size()), glm::ivec2(1, 1));
}

TEST(PixelGrids, CountRowsFromTheBottom) {
  const PixelGrid grid{{10, 11}, 1, {3, 5}};  // rows 0, 5 and 10 from the bottom
  EXPECT_EQ(grid.pixel({0, 0}), glm::ivec2(0, 0));
  EXPECT_EQ(grid.pixel({1, 2}), glm::ivec2(3, 10));
}

TEST(PixelGrids, HaveWholeTiles) {
  const PixelGrid grid{{20, 20}, 2, {3, 5}};  // columns 0, 1, 6, 7, ...; rows 0, 1, 10, 11 from the bottom
  EXPECT_EQ(grid.size(), glm::ivec2(8, 4));
  EXPECT_EQ(grid.pixel({1, 3}), glm::ivec2(1, 19));
  EXPECT_EQ(grid.pixel({2, 2}), glm::ivec2(6, 18));
  EXPECT_EQ(grid.pixel({7, 0}), glm::ivec2(19, 8));
}

/// How many columns of a grid lie at each place among eight, the stride of mres's coarsest level.
std::array<int, 8> columnsByPlace(const PixelGrid& grid) {
  std::array<int, 8> counts{};
  for (int x = 0; x < grid.size().x; ++x) ++counts.at(static_cast<std::size_t>(grid.pixel({x, 0}).x % 8));
  return counts;
}

TEST(PixelGrids, OfOddStridesMeetEveryPlaceBetweenThePixelsOfALevelAlikeOften) {
  EXPECT_THAT(columnsByPlace({{1920, 1}, 4, {5, 1}}), testing::Each(48));
  EXPECT_THAT(columnsByPlace({{1920, 1}, 4, {3, 1}}), testing::Each(80));
  EXPECT_THAT(columnsByPlace({{1944, 1}, 1, {9, 1}}), testing::Each(27));
}

TEST(PixelGrids, PickAllChannelsOfTheirPixels) {
  FloatImage picture{{4, 3}, 3, {}};
  for (int i = 0; i < 4 * 3 * 3; ++i) picture.pixels.push_back(static_cast<float>(i));
  const FloatImage values = valuesAt({{4, 3}, 1, {3, 2}}, picture);  // columns 0 and 3, rows 0 and 2
  EXPECT_EQ(values.size, glm::ivec2(2, 2));
  EXPECT_EQ(values.pixels, (std::vector<float>{0, 1, 2, 9, 10, 11, 24, 25, 26, 33, 34, 35}));
}

}  // namespace
}  // namespace host
