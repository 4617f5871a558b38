// The host's importance mask: combined with edges by maximum or minimum.
#include <algorithm>
#include <gmock/gmock.h>
#include <limits>
#include <random>

#include "mres/mask/importance_pass.h"
#include "tests/support/allocations.h"
#include "tests/support/gl_state.h"
#include "tests/support/gl_test.h"
#include "tests/support/glsl_function.h"
#include "tests/support/hostile_state.h"
#include "tests/support/mask_bench.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

constexpr float kFinest = 0.0f;
constexpr float kCoarsest = 0.75f;

gl::Texture2D randomTexture(GLenum format, int channels, glm::ivec2 size, unsigned seed) {
  std::mt19937 generator(seed);
  std::vector<std::uint8_t> texels(static_cast<std::size_t>(channels * size.x * size.y));
  std::ranges::generate(texels, [&] { return static_cast<std::uint8_t>(generator() % 256); });
  return {format, size, "test.random", 1, texels.data()};
}

TEST_F(GlTest, ImportanceIsSampledBilinearlyOverTheScreenAndCombinedWithTheEdges) {
  PassContext context;
  context.library = shaderLibrary();
  ImportancePass pass(context.library);
  for (const glm::ivec2 fullSize : {glm::ivec2(64, 48), glm::ivec2(97, 61)}) {
    for (const glm::ivec2 importanceSize : {glm::ivec2(1), glm::ivec2(7, 5), glm::ivec2(130, 77)}) {
      const gl::Texture2D edges = randomTexture(GL_RG8, 2, levelSize(fullSize, 1), 1);
      const gl::Texture2D importance = randomTexture(GL_R8, 1, importanceSize, 2);
      const Image edgeImage = readImage(edges, 2);
      const Image importanceImage = readImage(importance, 1);
      for (const MaskCombination combination : {kCombineByMaximum, kCombineByMinimum}) {
        const Frame frame{.importance = importance.id(), .size = fullSize};
        const Image combined = readImage(pass.draw(context, combination, 0, edges, frame), 2);
        ASSERT_EQ(combined.size, edgeImage.size);
        for (int i = 0; i < combined.size.x * combined.size.y; ++i) {
          const glm::ivec2 texel(i % combined.size.x, i / combined.size.x);
          const glm::dvec2 edge(edgeImage.at(texel, 0), edgeImage.at(texel, 1));
          const glm::dvec2 screen = (glm::dvec2(2 * texel) + 1.0) / glm::dvec2(fullSize);
          const double sample = bilinear(importanceImage, screen * glm::dvec2(importanceSize));
          // What is important is so even where edges of normals, red, do not show.
          const glm::dvec2 expected = combination == kCombineByMaximum
                                          ? glm::dvec2(edge.x, std::max(edge.y, sample))
                                          : glm::min(edge, sample);
          for (int channel = 0; channel < 2; ++channel)
            ASSERT_NEAR(static_cast<double>(combined.at(texel, channel)), expected[channel], 2.0 / 255.0)
                << texel.x << ", " << texel.y << " of " << fullSize.x << ", " << channel;
        }
      }
    }
  }
}

class Importance : public GlTest {
 protected:
  Importance() { refineByMasks(multiResolution_); }

  Image picture(Effect& effect, const SyntheticGBuffer& gbuffer, const gl::Texture2D& importance) {
    Frame frame = gbuffer.frame();
    frame.importance = importance.id();
    return {frame.size, 1, renderPicture(multiResolution_, effect, frame)};
  }

  const glm::ivec2 size_{193, 129};
  const SyntheticGBuffer plane_{size_, perspective(size_), plane({0.3, 0.2, 1.0}, -6.0)};
  const SyntheticGBuffer room_{size_, perspective(size_), room()};
  const gl::Texture2D nothing_ = makeImportance({0.0f});
  const gl::Texture2D everything_ = makeImportance({1.0f});
  const gl::Texture2D leftHalf_ = makeImportance({1.0f, 1.0f, 0.0f, 0.0f});
  MultiResolution multiResolution_;

 private:
  static gl::Texture2D makeImportance(const std::vector<float>& columns) {
    return {GL_R32F, {static_cast<int>(columns.size()), 1}, "test.importance", 1, columns.data()};
  }
};

TEST_F(Importance, RefinesWhereThereAreNoEdges) {
  TestEffect effect(levelNumbers());
  EXPECT_THAT(picture(effect, plane_, nothing_).texels, testing::Each(kCoarsest));
  EXPECT_THAT(picture(effect, plane_, everything_).texels, testing::Each(kFinest));
  const Image half = picture(effect, plane_, leftHalf_);
  for (int y = 0; y < size_.y; ++y) {
    ASSERT_EQ(half.at({size_.x / 4, y}), kFinest) << y;
    ASSERT_EQ(half.at({size_.x - 20, y}), kCoarsest) << y;
  }
}

TEST_F(Importance, ByMinimumLimitsWhatEdgesRefine) {
  TestEffect effect(levelNumbers());
  const Picture byEdges = renderPicture(multiResolution_, effect, room_.frame());
  multiResolution_.settings().mask.combination = kCombineByMinimum;
  EXPECT_EQ(picture(effect, room_, everything_).texels, byEdges);
  EXPECT_THAT(picture(effect, room_, nothing_).texels, testing::Each(kCoarsest));
  EXPECT_THAT(picture(effect, plane_, everything_).texels, testing::Each(kCoarsest));
  const Image left = picture(effect, room_, leftHalf_);
  EXPECT_EQ(*std::ranges::min_element(left.texels), kFinest);
  for (int y = 0; y < size_.y; ++y) ASSERT_EQ(left.at({size_.x - 20, y}), kCoarsest) << y;
}

TEST_F(Importance, CombinesWithTheEdgesOfAPreview) {
  TestEffect::Recipe recipe = levelNumbers();
  recipe.preview = "return vec2(surface.pixel.x < 40.0 ? 0.0 : 1.0);";
  TestEffect effect(recipe);
  EXPECT_THAT(picture(effect, plane_, everything_).texels, testing::Each(kFinest));
  EXPECT_EQ(picture(effect, plane_, nothing_).at({40, 64}), kFinest);
  multiResolution_.settings().mask.combination = kCombineByMinimum;
  EXPECT_EQ(picture(effect, plane_, leftHalf_).at({40, 64}), kFinest);
  EXPECT_THAT(picture(effect, plane_, nothing_).texels, testing::Each(kCoarsest));
}

TEST_F(Importance, IsStillAskedWhetherItPays) {
  TestEffect effect({.body = "return vec4(0.25);"});
  MultiResolution multiResolution({.measureCoverage = true});
  Frame frame = plane_.frame();
  frame.importance = everything_.id();
  for (int i = 0; i < 2; ++i) {
    multiResolution.render(effect, frame);
    glFinish();
  }
  multiResolution.render(effect, frame);
  const std::vector<LevelReport>& levels = multiResolution.report().levels;
  EXPECT_EQ(levels[0].coverage, 0.0);
  EXPECT_EQ(levels[2].coverage, 1.0);
}

TEST_F(Importance, CostsNothingWhereThereIsNone) {
  TestEffect effect(levelNumbers());
  multiResolution_.setProfiling(gl::Profiler::Mode::finish);
  const auto hasItsStage = testing::Contains(testing::Field(&gl::StageTime::name, "mres.importance"));
  const Picture without = renderPicture(multiResolution_, effect, room_.frame());
  EXPECT_THAT(multiResolution_.report().stages, testing::Not(hasItsStage));
  const std::size_t bytes = multiResolution_.report().bytes;
  EXPECT_NE(picture(effect, room_, everything_).texels, without);
  EXPECT_THAT(multiResolution_.report().stages, hasItsStage);
  EXPECT_GT(multiResolution_.report().bytes, bytes);
  EXPECT_EQ(renderPicture(multiResolution_, effect, room_.frame()), without);
}

TEST_F(Importance, ByMinimumLimitsWhatFoldsRefine) {
  const SyntheticGBuffer folded(size_, perspective(size_), curtain(5.0, 1.5, 40.0));
  TestEffect effect(levelNumbers());
  multiResolution_.settings() = {};
  multiResolution_.settings().mask.errorBudget = 0.0f;
  multiResolution_.settings().mask.combination = kCombineByMinimum;
  EXPECT_THAT(picture(effect, folded, nothing_).texels, testing::Each(kCoarsest));
  const Picture byFolds = renderPicture(multiResolution_, effect, folded.frame());
  EXPECT_THAT(byFolds, testing::Not(testing::Each(kCoarsest)));
  EXPECT_EQ(picture(effect, folded, everything_).texels, byFolds);
}

TEST_F(Importance, BringsNothingUndefinedIntoThePictureNorAllocates) {
  TestEffect effect({.body = "return vec4(fract(surface.position.x));", .filtered = true});
  Frame frame = room_.frame();
  frame.importance = leftHalf_.id();
  for (const Technique technique : {Technique::paper, Technique::multiResolution}) {
    multiResolution_.settings().technique = technique;
    const Picture clean = renderPicture(multiResolution_, effect, frame);
    multiResolution_.fillTargets(std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(renderPicture(multiResolution_, effect, frame), clean);
    const AllocationCounter allocations;
    multiResolution_.render(effect, frame);
    EXPECT_EQ(allocations.count(), 0u);
  }
}

TEST_F(Importance, LeavesTheHostsStateAlone) {
  TestEffect effect(levelNumbers());
  const Picture expected = picture(effect, room_, leftHalf_).texels;
  Frame frame = room_.frame();
  frame.importance = leftHalf_.id();
  GLuint result = 0;
  {
    const HostileState hostile;
    const GlState before = captureGlState();
    result = multiResolution_.render(effect, frame);
    EXPECT_THAT(differences(before, captureGlState()), testing::IsEmpty());
  }
  EXPECT_EQ(readPixels(result, size_, 1), expected);
}

}  // namespace
}  // namespace mres::test
