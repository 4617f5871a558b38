#include "host/scene/builtin/procedural_textures.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace host::textures {
namespace {

const glm::vec3 kLight(0.8f, 0.7f, 0.6f);
const glm::vec3 kDark(0.3f, 0.2f, 0.1f);

struct Named {
  const char* name;
  Pattern pattern;
};

std::vector<Named> allPatterns() {
  return {{"wood", wood(kLight, kDark, 1, 1)},
          {"planks", wood(kLight, kDark, 4, 1)},
          {"marble", marble(kLight, kDark, 0.5f, 1)},
          {"plaster", plaster(kLight, 0.2f, 1)},
          {"fabric", fabric(kLight, kDark, 16, 1)},
          {"masonry", masonry({.blocks = {2, 4}}, plaster(kLight, 0.2f, 1), 2)},
          {"checker", checker(4, marble(kLight, kDark, 0.5f, 1), plaster(kDark, 0.2f, 1), kDark)}};
}

TEST(ProceduralTextures, NoiseStaysInRangeAndRepeats) {
  for (int i = 0; i < 200; ++i) {
    const glm::vec2 at(0.37f * static_cast<float>(i), 0.11f * static_cast<float>(i));
    const float value = fractalNoise(at, {5, 3}, 4, 9);
    EXPECT_GE(value, 0.0f);
    EXPECT_LE(value, 1.0f);
    EXPECT_NEAR(value, fractalNoise(at + glm::vec2(5.0f, 3.0f), {5, 3}, 4, 9), 1e-3f);
  }
}

TEST(ProceduralTextures, NoiseIsTheSameOnEveryMachine) {
  EXPECT_FLOAT_EQ(cellNoise({0, 0}, 0), 0.0f);  // the mixer maps zero to zero
  EXPECT_NEAR(valueNoise({0.0f, 0.0f}, {4, 4}, 1), cellNoise({0, 0}, 1), 1e-6f);
  EXPECT_NE(cellNoise({1, 2}, 3), cellNoise({2, 1}, 3));
}

TEST(ProceduralTextures, PatternsStayInRangeAndRepeat) {
  constexpr float kJustInside = 1e-4f;
  for (const Named& named : allPatterns()) {
    if (std::string(named.name) == "fabric") continue;  // a thread changes over to the next one at its border
    for (int i = 0; i < 64; ++i) {
      const float t = (static_cast<float>(i) + 0.5f) / 64.0f;
      const Surface left = named.pattern({kJustInside, t});
      const Surface right = named.pattern({1.0f - kJustInside, t});
      const Surface top = named.pattern({t, kJustInside});
      const Surface bottom = named.pattern({t, 1.0f - kJustInside});
      for (int channel = 0; channel < 3; ++channel) {
        EXPECT_GE(left.color[channel], 0.0f) << named.name;
        EXPECT_LE(left.color[channel], 1.0f) << named.name;
      }
      EXPECT_NEAR(left.height, right.height, 1e-3f) << named.name;
      EXPECT_NEAR(top.height, bottom.height, 1e-3f) << named.name;
      EXPECT_LT(glm::distance(left.color, right.color), 0.35f) << named.name;
    }
  }
}

TEST(ProceduralTextures, ImagesAreOpaqueAndDeterministic) {
  for (const Named& named : allPatterns()) {
    const Image image = baseColorImage(named.name, 32, named.pattern);
    ASSERT_EQ(image.pixels.size(), 32U * 32U * 4U);
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) ASSERT_EQ(image.pixels[i], 255);
    EXPECT_EQ(image.pixels, baseColorImage(named.name, 32, named.pattern).pixels);
  }
}

TEST(ProceduralTextures, NormalMapsFollowTheSlope) {
  const Image flat = normalImage("flat", 16, [](glm::vec2) { return Surface{}; });
  EXPECT_EQ(flat.pixels[0], 128);
  EXPECT_EQ(flat.pixels[1], 128);
  EXPECT_EQ(flat.pixels[2], 255);
  // A slope that rises to the right by 45 degrees leans to the left.
  const Image slope = normalImage("slope", 16, [](glm::vec2 uv) { return Surface{kLight, uv.x}; });
  const std::size_t middle = (8 * 16 + 8) * 4;
  EXPECT_NEAR(slope.pixels[middle], 127.5 - 127.5 * std::sqrt(0.5), 2.0);
  // One that rises downwards leans up, which is bright green as in glTF.
  const Image rise = normalImage("rise", 16, [](glm::vec2 uv) { return Surface{kLight, uv.y}; });
  EXPECT_NEAR(rise.pixels[middle + 1], 127.5 + 127.5 * std::sqrt(0.5), 2.0);
}

}  // namespace
}  // namespace host::textures
