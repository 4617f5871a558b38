// What each peer makes of a picture.
#include <algorithm>
#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <initializer_list>
#include <optional>
#include <string>

#include "effects/ssao/ssao.h"
#include "shaders/peers/peer_blocks.h"
#include "tests/gpu/peers_support.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"
#include "tests/support/unfiltered.h"

namespace mres::test {
namespace {

/// Those whose pictures are not the full resolution's.
constexpr std::array kUpsampling{"half-bilinear", "half-joint",   "quarter-bilinear",
                                 "quarter-joint", "checkerboard", "adaptive-tiles"};
constexpr std::array kOnPlanes{"half-joint", "quarter-joint", "checkerboard", "adaptive-tiles"};

constexpr double kHalfRounding = 1.0 / 2048.0;

TEST_F(PeersTest, ARampOnAPlaneIsWhereItIs) {
  for (const glm::ivec2 size : {glm::ivec2(256, 192), glm::ivec2(251, 183)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), plane({0.0, 0.0, 1.0}, -10.0));
    for (const bool filtered : {false, true}) {
      TestEffect effect({.body = "return vec4(dot(surface.pixel, vec2(0.0015, 0.002)));",
                         .filtered = filtered,
                         .name = filtered ? "filtered" : "unfiltered"});
      const Image reference{size, 1, full(effect, gbuffer.frame())};
      for (const char* name : kUpsampling) {
        const Image image{size, 1, picture(name, effect, gbuffer.frame())};
        constexpr int kBorder = 16;  // where filter and interpolation lack neighbours
        for (int y = kBorder; y < size.y - kBorder; ++y)
          for (int x = kBorder; x < size.x - kBorder; ++x)
            ASSERT_NEAR(image.at({x, y}), reference.at({x, y}), 0.002) << name << " at " << x << ", " << y;
      }
    }
  }
}

/// The nearer of two surfaces is to the right of an upright edge. Without `back` there is sky behind it.
RayCaster step(std::optional<double> back) {
  return [back](glm::dvec3 origin, glm::dvec3 direction) -> std::optional<Hit> {
    const bool front = direction.x > 0.13;
    if (!front && !back) return std::nullopt;
    return plane({0.0, 0.0, 1.0}, front ? -2.0 : -*back)(origin, direction);
  };
}

TEST_F(PeersTest, OnPlanesNothingBleedsAcrossAStepButBilinearlyItDoes) {
  for (const glm::ivec2 size : {glm::ivec2(67, 41), glm::ivec2(64, 40), glm::ivec2(75, 33)}) {
    for (const std::optional<double> back :
         {std::optional(2.6), std::optional(40.0), std::optional<double>()}) {
      const SyntheticGBuffer gbuffer(size, perspective(size), step(back));
      for (const bool filtered : {false, true}) {
        TestEffect effect({.body = "return vec4(surface.depth < 2.5 ? 0.25 : 0.75);",
                           .filtered = filtered,
                           .background = glm::vec4(0.75f),
                           .name = filtered ? "filtered" : "unfiltered"});
        const Picture reference = full(effect, gbuffer.frame());
        ASSERT_THAT(reference, testing::Each(testing::AnyOf(0.25f, 0.75f)));
        for (const char* name : kOnPlanes)
          EXPECT_EQ(picture(name, effect, gbuffer.frame()), reference) << name << " at " << size.x;
        for (const char* name : {"half-bilinear", "quarter-bilinear"})
          EXPECT_TRUE(std::ranges::any_of(picture(name, effect, gbuffer.frame()),
                                          [](float value) { return value > 0.3f && value < 0.7f; }))
              << name << " at " << size.x;
      }
    }
  }
}

TEST_F(PeersTest, AThinThingTakesTheValueThatIsNearestInDepth) {
  const glm::ivec2 size(96, 64);
  // A post of a pixel's width stands before a wall that is nearer on the left.
  const auto scene = [](glm::dvec3 origin, glm::dvec3 direction) {
    const bool post = std::abs(direction.x - 0.006) < 0.006;
    return plane({0.0, 0.0, 1.0}, post ? -2.0 : direction.x < 0.0 ? -3.0 : -9.0)(origin, direction);
  };
  const SyntheticGBuffer gbuffer(size, perspective(size), scene);
  TestEffect effect({.body = "return vec4(surface.depth < 2.5 ? 1.0 : surface.depth < 4.0 ? 0.25 : 0.75);"});
  const Picture reference = full(effect, gbuffer.frame());
  ASSERT_THAT(reference, testing::Contains(1.0f)) << "the post is seen";
  for (const char* name : {"half-joint", "quarter-joint"}) {
    const Picture image = picture(name, effect, gbuffer.frame());
    for (std::size_t i = 0; i < image.size(); ++i) {
      if (reference[i] != 1.0f) continue;
      ASSERT_TRUE(image[i] == 1.0f || image[i] == 0.25f) << name << ", " << image[i];
    }
  }
}

TEST_F(PeersTest, UpsamplingByDepthAndNormalIsBetterAndHalfIsBetterThanAQuarter) {
  const glm::ivec2 size(320, 240);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  Ssao ssao({.samples = 32});
  const Picture reference = full(ssao, gbuffer.frame());
  const auto errorOf = [&](const char* name) {
    return rootMeanSquare(picture(name, ssao, gbuffer.frame()), reference);
  };
  EXPECT_LT(errorOf("half-joint"), errorOf("half-bilinear"));
  EXPECT_LT(errorOf("quarter-joint"), errorOf("quarter-bilinear"));
  EXPECT_LT(errorOf("half-joint"), errorOf("quarter-joint"));
  EXPECT_LT(errorOf("adaptive-tiles"), errorOf("quarter-joint"));
}

TEST_F(PeersTest, InterleavedIsTheFullResolutionToTheLastBit) {
  Ssao ssao({.samples = 8});
  Unfiltered<Ssao> unfiltered(SsaoSettings{.samples = 8});
  TestEffect radiance(
      {.body = "return vec4(fract(surface.position), 1.0);", .channels = 3, .filtered = true});
  for (const glm::ivec2 size : {glm::ivec2(96, 64), glm::ivec2(71, 53), glm::ivec2(17, 9)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), room());
    for (Effect* effect : std::initializer_list<Effect*>{&ssao, &unfiltered, &radiance})
      EXPECT_EQ(picture("interleaved", *effect, gbuffer.frame()), full(*effect, gbuffer.frame()))
          << effect->description().name << " at " << size.x << "x" << size.y;
  }
}

bool isEvaluated(glm::ivec2 pixel) {
  const glm::ivec2 block = pixel / CHECKERBOARD_BLOCK;
  return (block.x + block.y) % 2 == 0;
}

TEST_F(PeersTest, TheCheckerboardEvaluatesHalfOfThePixelsAsTheyAre) {
  for (const glm::ivec2 size : {glm::ivec2(96, 64), glm::ivec2(71, 53), glm::ivec2(17, 9)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), room());
    Unfiltered<Ssao> ssao(SsaoSettings{.samples = 8});
    const Image image{size, 1, picture("checkerboard", ssao, gbuffer.frame())};
    const Image reference{size, 1, full(ssao, gbuffer.frame())};
    for (int i = 0; i < size.x * size.y; ++i) {
      const glm::ivec2 pixel(i % size.x, i / size.x);
      if (!isEvaluated(pixel)) continue;
      ASSERT_EQ(image.at(pixel), reference.at(pixel)) << pixel.x << ", " << pixel.y;
    }
  }
}

TEST_F(PeersTest, TheCheckerboardsFilterLeavesNoNoise) {
  const glm::ivec2 size(96, 64);
  const SyntheticGBuffer gbuffer(size, perspective(size), plane({0.3, 0.2, 1.0}, -5.0));
  TestEffect effect({.body = "int i = surface.noisePixel.y * 4 + surface.noisePixel.x;\n"
                             "return vec4(float(i * 7 % 16) / 16.0);",
                     .filtered = true});
  const Image image{size, 1, picture("checkerboard", effect, gbuffer.frame())};
  constexpr int kBorder = 4;  // off the screen there is nothing to fill from
  for (int y = kBorder; y < size.y - kBorder; ++y)
    for (int x = kBorder; x < size.x - kBorder; ++x)
      ASSERT_NEAR(image.at({x, y}), image.at(size / 2), 2.0 * kHalfRounding) << x << ", " << y;
}

TEST_F(PeersTest, TellHowManyPixelsTheyEvaluate) {
  const glm::ivec2 size(64, 48);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  TestEffect effect({.body = "return vec4(0.25);"});
  const auto workOf = [&](const char* name) {
    const auto peer = host::makePeer(name, effect.description());
    peer->render(effect, gbuffer.frame());
    return peer->work();
  };
  EXPECT_EQ(workOf("half-bilinear"), 0.25);
  EXPECT_EQ(workOf("half-joint"), 0.25);
  EXPECT_EQ(workOf("quarter-bilinear"), 0.0625);
  EXPECT_EQ(workOf("quarter-joint"), 0.0625);
  EXPECT_EQ(workOf("checkerboard"), 0.5);
  EXPECT_EQ(workOf("interleaved"), 1.0);
}

/// To the left of pixel 128 the value is 0.25, of the full level 0.125; to the right neighbours differ at
/// every level, but the full one has 0.5.
constexpr const char* kCalmAndBusy =
    "bool busy = surface.pixel.x > 128.0;\n"
    "if (levelStride == 1) return vec4(busy ? 0.5 : 0.125);\n"
    "return vec4(busy ? float((surface.levelPixel.x + surface.levelPixel.y) & 1) : 0.25);";

TEST_F(PeersTest, AdaptiveTilesAreCoarseWhereItIsCalmAndFineWhereItIsBusy) {
  const glm::ivec2 size(256, 128);
  const SyntheticGBuffer gbuffer(size, perspective(size), plane({0.0, 0.0, 1.0}, -10.0));
  TestEffect effect({.body = kCalmAndBusy});
  const auto peer = host::makePeer("adaptive-tiles", effect.description(), {.measureWork = true});
  peer->render(effect, gbuffer.frame());
  glFinish();
  const Image image{size, 1, picture(*peer, effect, gbuffer.frame())};
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < 128 - ADAPTIVE_TILE; ++x) ASSERT_EQ(image.at({x, y}), 0.25f) << x << ", " << y;
    for (int x = 128; x < size.x; ++x) ASSERT_EQ(image.at({x, y}), 0.5f) << x << ", " << y;
  }
  EXPECT_GT(peer->work(), 0.5 + 1.0 / 16.0);
  EXPECT_LT(peer->work(), 0.6 + 1.0 / 16.0);
}

TEST_F(PeersTest, AHigherErrorBudgetMakesCoarserTiles) {
  const glm::ivec2 size(256, 192);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  Ssao ssao({.samples = 16});
  double before = 1.1 + 1.0 / 16.0;
  for (const float budget : {0.0f, 0.0025f, 0.01f, 1.0f}) {
    const auto peer =
        host::makePeer("adaptive-tiles", ssao.description(), {.errorBudget = budget, .measureWork = true});
    for (int frame = 0; frame < 2; ++frame) {
      peer->render(ssao, gbuffer.frame());
      glFinish();
    }
    EXPECT_LT(peer->work(), before) << budget;
    before = peer->work();
  }
  EXPECT_EQ(before, 1.0 / 16.0) << "nothing differs as much";
}

}  // namespace
}  // namespace mres::test
