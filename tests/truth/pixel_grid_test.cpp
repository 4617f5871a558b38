#include "host/truth/pixel_grid.h"

#include <gtest/gtest.h>

namespace host {
namespace {

TEST(PixelGrids, LeaveOutWhatLiesOutside) {
  EXPECT_EQ((PixelGrid{{1920, 1080}, 4}.size()), glm::ivec2(480, 270));
  EXPECT_EQ((PixelGrid{{1922, 1083}, 4}.size()), glm::ivec2(480, 271));
  EXPECT_EQ((PixelGrid{{7, 5}, 1}.size()), glm::ivec2(7, 5));
  EXPECT_EQ((PixelGrid{{4, 2}, 8}.size()), glm::ivec2(0, 0));
}

TEST(PixelGrids, CountRowsFromTheBottom) {
  const PixelGrid grid{{10, 11}, 4};  // rows 2, 6 and 10 from the bottom
  EXPECT_EQ(grid.pixel({0, 0}), glm::ivec2(2, 0));
  EXPECT_EQ(grid.pixel({1, 2}), glm::ivec2(6, 8));
}

TEST(PixelGrids, PickAllChannelsOfTheirPixels) {
  FloatImage picture{{4, 3}, 3, {}};
  for (int i = 0; i < 4 * 3 * 3; ++i) picture.pixels.push_back(static_cast<float>(i));
  const FloatImage values = valuesAt({{4, 3}, 2}, picture);  // columns 1 and 3, row 1
  EXPECT_EQ(values.size, glm::ivec2(2, 1));
  EXPECT_EQ(values.pixels, (std::vector<float>{15, 16, 17, 21, 22, 23}));
}

}  // namespace
}  // namespace host
