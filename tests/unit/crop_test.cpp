#include "host/image/crop.h"

#include <gtest/gtest.h>
#include <utility>

namespace host {
namespace {

TEST(Crop, IsAroundThePlaceAndInsideOfTheImage) {
  FloatImage image{{6, 4}, 3, {}};
  for (int i = 0; i < 6 * 4 * 3; ++i) image.pixels.push_back(static_cast<float>(i));
  for (const auto& [centre, corner] :
       {std::pair(glm::ivec2(3, 2), glm::ivec2(2, 1)), {{0, 0}, {0, 0}}, {{5, 3}, {4, 2}}}) {
    const FloatImage crop = cropAround(image, centre, 2);
    ASSERT_EQ(crop.size, glm::ivec2(2));
    ASSERT_EQ(crop.pixels.size(), 12U);
    for (int i = 0; i < 12; ++i) {
      const int x = corner.x + i / 3 % 2;
      const int y = corner.y + i / 6;
      EXPECT_EQ(crop.pixels[i], static_cast<float>((y * 6 + x) * 3 + i % 3)) << corner.x << ", " << i;
    }
  }
  EXPECT_EQ(cropAround(image, {5, 3}, 100).pixels, image.pixels);
}

}  // namespace
}  // namespace host
