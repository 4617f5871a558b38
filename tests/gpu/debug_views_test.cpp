// The pictures of how a frame was decided.
#include <algorithm>
#include <cstddef>
#include <gmock/gmock.h>
#include <stdexcept>
#include <vector>

#include "effects/ssao/ssao.h"
#include "mres/mres.h"
#include "tests/gpu/multi_resolution_support.h"
#include "tests/support/gl_test.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

class DebugViews : public MultiResolutionTest {
 protected:
  static glm::vec3 colorAt(GLuint texture, glm::ivec2 size, glm::ivec2 pixel) {
    const std::vector<float> texels = readPixels(texture, size, 3);
    const auto index = static_cast<std::size_t>(3 * (pixel.y * size.x + pixel.x));
    return {texels[index], texels[index + 1], texels[index + 2]};
  }

  /// One channel of the last frame's edges.
  std::vector<float> edgesIn(std::size_t channel, glm::ivec2 size) {
    const std::vector<float> texels = readPixels(multiResolution_.debugView(DebugView::edges), size, 3);
    std::vector<float> values;
    for (std::size_t i = channel; i < texels.size(); i += 3) values.push_back(texels[i]);
    return values;
  }
};

constexpr std::size_t kNormals = 0;
constexpr std::size_t kDepth = 1;
constexpr std::size_t kEffect = 2;

TEST_F(DebugViews, ThrowBeforeTheFirstFrame) {
  EXPECT_THROW(multiResolution_.debugView(DebugView::levels), std::logic_error);
}

// The box shows its front alone, which faces as the plane behind it does.
TEST_F(DebugViews, ShowStepsOfDepthInGreenWhereTheyAre) {
  const glm::ivec2 size(129, 97);
  const SyntheticGBuffer gbuffer(
      size, perspective(size),
      nearest({plane({0.0, 0.0, 1.0}, -6.0), box({-1.0, -1.0, -5.0}, {1.0, 1.0, -4.0})}));
  Ssao ssao(ssaoWith(15, 1));
  static_cast<void>(mixed(ssao, gbuffer.frame()));
  const GLuint edges = multiResolution_.debugView(DebugView::edges);
  const glm::ivec2 side = pixelOf(perspective(size), size, {1.0, 0.0, -4.0});
  EXPECT_EQ(colorAt(edges, size, side), glm::vec3(0.0f, 1.0f, 0.0f));
  for (const glm::ivec2 flat : {glm::ivec2(2), size / 2, side - glm::ivec2(6, 0), side + glm::ivec2(6, 0)})
    EXPECT_EQ(colorAt(edges, size, flat), glm::vec3(0.0f)) << flat.x << ", " << flat.y;
  EXPECT_GT(std::ranges::count(edgesIn(kDepth, size), 1.0f), 100);
  EXPECT_THAT(edgesIn(kNormals, size), testing::Each(0.0f));
  EXPECT_THAT(edgesIn(kEffect, size), testing::Each(0.0f));
}

TEST_F(DebugViews, ShowTurnsOfNormalsInRed) {
  const glm::ivec2 size(128, 96);
  const SyntheticGBuffer gbuffer(size, perspective(size), withRandomNormals(plane({0.0, 0.0, 1.0}, -6.0)));
  Ssao ssao(ssaoWith(15, 1));
  static_cast<void>(mixed(ssao, gbuffer.frame()));
  EXPECT_THAT(edgesIn(kNormals, size), testing::Each(1.0f));
  EXPECT_THAT(edgesIn(kDepth, size), testing::Each(0.0f));
  EXPECT_THAT(edgesIn(kEffect, size), testing::Each(0.0f));
}

TEST_F(DebugViews, ShowTheEffectsOwnEdgesInBlueAndGeometrysWhereTheyAreAskedFor) {
  const glm::ivec2 size(129, 97);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  TestEffect effect(
      {.body = "return vec4(0.5);", .preview = "return vec2(surface.pixel.x < 48.0 ? 0.0 : 1.0);"});
  static_cast<void>(mixed(effect, gbuffer.frame()));
  const std::vector<float> own = edgesIn(kEffect, size);
  for (int i = 0; i < size.x * size.y; ++i) {
    const bool isBeside = i % size.x >= 46 && i % size.x < 50;  // two texels of two pixels
    ASSERT_EQ(own[static_cast<std::size_t>(i)], isBeside ? 1.0f : 0.0f) << i;
  }
  EXPECT_THAT(edgesIn(kNormals, size), testing::Each(0.0f));
  EXPECT_THAT(edgesIn(kDepth, size), testing::Each(0.0f));
  multiResolution_.settings().mask.geometryAlways = true;
  static_cast<void>(mixed(effect, gbuffer.frame()));
  EXPECT_THAT(edgesIn(kNormals, size), testing::Contains(1.0f));
  EXPECT_THAT(edgesIn(kDepth, size), testing::Contains(1.0f));
  EXPECT_EQ(edgesIn(kEffect, size), own);
}

TEST_F(DebugViews, ShowTheLevelThatRendered) {
  const glm::ivec2 size(129, 97);
  const SyntheticGBuffer gbuffer(size, perspective(size), plane({0.1, 0.1, 1.0}, -6.0));
  Ssao ssao(ssaoWith(15, 1));
  static_cast<void>(mixed(ssao, gbuffer.frame()));
  EXPECT_EQ(colorAt(multiResolution_.debugView(DebugView::levels), size, {20, 20}), glm::vec3(0.0f))
      << "eighth";
  Ssao half(ssaoWith(3, 1));
  static_cast<void>(mixed(half, gbuffer.frame()));
  EXPECT_GT(colorAt(multiResolution_.debugView(DebugView::levels), size, {20, 20}).g, 0.5f)
      << "half is green";
  static_cast<void>(full(ssao, gbuffer.frame()));
  EXPECT_GT(colorAt(multiResolution_.debugView(DebugView::levels), size, {20, 20}).r, 0.5f) << "full is red";
}

TEST_F(DebugViews, ShowThatOnlyTheSideWithDetailHasTheFullResolution) {
  const glm::ivec2 size(192, 128);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  TestEffect effect({.body = "return vec4(surface.pixel.x < 96.0 ? log2(float(levelStride)) / 4.0 : 0.5);"});
  static_cast<void>(mixed(effect, gbuffer.frame()));
  const std::vector<float> colors = readPixels(multiResolution_.debugView(DebugView::levels), size, 3);
  constexpr int kBorder = 96 + 16;  // two pixels of the coarsest level see both halves
  int refinedLeft = 0;
  int refinedRight = 0;
  for (int i = 0; i < size.x * size.y; ++i) {
    const bool refined = colors[3 * i] > 0.5f;  // red: full
    (i % size.x < kBorder ? refinedLeft : refinedRight) += refined ? 1 : 0;
  }
  EXPECT_GT(refinedLeft, 96 * size.y / 10);
  EXPECT_EQ(refinedRight, 0);
}

TEST_F(DebugViews, OfTheFullTechniqueHaveNoEdges) {
  const glm::ivec2 size(64, 48);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  Ssao ssao(ssaoWith(15, 1));
  static_cast<void>(full(ssao, gbuffer.frame()));
  EXPECT_THAT(readPixels(multiResolution_.debugView(DebugView::edges), size, 3), testing::Each(0.0f));
}

}  // namespace
}  // namespace mres::test
