// Disjoint tiles: every pixel in exactly one level, and nothing undefined between them.
#include <algorithm>
#include <gmock/gmock.h>
#include <limits>

#include "effects/ssao/ssao.h"
#include "tests/support/allocations.h"
#include "tests/support/gl_state.h"
#include "tests/support/gl_test.h"
#include "tests/support/hostile_state.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

class Disjoint : public GlTest {
 protected:
  Disjoint() { multiResolution_.settings().mask.disjoint = true; }

  /// The shares of the levels' pixels that an effect rendered, finest first.
  std::vector<double> coverage(Effect& effect, const Frame& frame) {
    for (int i = 0; i < 2; ++i) {
      multiResolution_.render(effect, frame);
      glFinish();
    }
    multiResolution_.render(effect, frame);
    std::vector<double> shares;
    for (const LevelReport& level : multiResolution_.report().levels) shares.push_back(level.coverage);
    return shares;
  }

  MultiResolution multiResolution_{{.measureCoverage = true}};
};

double sum(const std::vector<double>& shares) {
  double total = 0.0;
  for (const double share : shares) total += share;
  return total;
}

TEST_F(Disjoint, CoverageAddsUpToOneScreen) {
  const glm::ivec2 size(320, 256);  // a multiple of every level's pixels
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  for (const unsigned levels : {0b1111u, 0b1101u, 0b0111u, 0b0011u, 0b0101u}) {
    TestEffect effect(levelNumbers(levelSubset(levels)));
    const std::vector<double> shares = coverage(effect, gbuffer.frame());
    EXPECT_NEAR(sum(shares), 1.0, 1e-9) << levels;
    EXPECT_THAT(shares, testing::Each(testing::Gt(0.02))) << levels;
  }
  TestEffect extremes(levelNumbers(levelSubset(0b1001)));
  EXPECT_GE(sum(coverage(extremes, gbuffer.frame())), 1.0) << "pixels of 8 straddle blocks of 4";
  EXPECT_LT(sum(coverage(extremes, gbuffer.frame())), 1.3);
}

TEST_F(Disjoint, EveryPixelShowsTheLevelThatItsZoneSays) {
  const glm::ivec2 size(195, 131);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  TestEffect effect(levelNumbers());
  const Picture picture = renderPicture(multiResolution_, effect, gbuffer.frame());
  const std::vector<float> levels = readPixels(multiResolution_.debugView(DebugView::levels), size, 3);
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const bool full = levels[3 * i] > 0.5f;
    ASSERT_EQ(picture[i] == 0.0f, full) << i << ": where nothing else is rendered nothing is blended in";
  }
}

TEST_F(Disjoint, AConstantGivesTheSameConstantAtEverySize) {
  for (const glm::ivec2 size : {glm::ivec2(1), glm::ivec2(15), glm::ivec2(31, 17), glm::ivec2(127, 61),
                                glm::ivec2(73, 65), glm::ivec2(251, 257)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), room());
    for (unsigned levels = 1; levels < 16; levels += 2) {
      for (const bool filtered : {false, true}) {
        TestEffect effect({.body = "return vec4(0.375);",
                           .filtered = filtered,
                           .levels = levelSubset(levels),
                           .background = glm::vec4(0.375f)});
        multiResolution_.forget("test");
        ASSERT_THAT(renderPicture(multiResolution_, effect, gbuffer.frame()), testing::Each(0.375f))
            << size.x << "x" << size.y << ", levels " << levels;
      }
    }
  }
}

TEST_F(Disjoint, NothingUndefinedIsEverComposited) {
  for (const glm::ivec2 size : {glm::ivec2(97, 61), glm::ivec2(64, 64), glm::ivec2(33, 17)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), room());
    for (unsigned levels = 1; levels < 16; levels += 2) {
      Ssao ssao({.samples = 4, .levels = levelSubset(levels)});
      const Picture clean = renderPicture(multiResolution_, ssao, gbuffer.frame());
      ASSERT_TRUE(isFinite(clean));
      for (const float poison : {std::numeric_limits<float>::quiet_NaN(), -60000.0f, 60000.0f}) {
        multiResolution_.fillTargets(poison);
        ASSERT_EQ(renderPicture(multiResolution_, ssao, gbuffer.frame()), clean)
            << size.x << "x" << size.y << ", levels " << levels << ", poison " << poison;
      }
    }
  }
}

TEST_F(Disjoint, RefinesAtEveryEdgeWhateverTheThreshold) {
  const glm::ivec2 size(192, 128);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  TestEffect effect({.body = "return vec4(0.25);"});
  EXPECT_GT(coverage(effect, gbuffer.frame()).front(), 0.05);
  const Picture picture = renderPicture(multiResolution_, effect, gbuffer.frame());
  multiResolution_.settings().mask.errorBudget = 0.0f;
  EXPECT_EQ(renderPicture(multiResolution_, effect, gbuffer.frame()), picture);
}

TEST_F(Disjoint, IsCloseToTheNaivePictureAndLeavesTheOtherModesAlone) {
  const glm::ivec2 size(320, 240);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  Ssao ssao({.samples = 32});
  const Picture disjoint = renderPicture(multiResolution_, ssao, gbuffer.frame());
  multiResolution_.settings().mask.disjoint = false;
  const Picture inclusive = renderPicture(multiResolution_, ssao, gbuffer.frame());
  MultiResolution fresh;
  EXPECT_EQ(renderPicture(fresh, ssao, gbuffer.frame()), inclusive) << "after a disjoint frame";
  multiResolution_.settings().mask.disjoint = true;
  EXPECT_EQ(renderPicture(multiResolution_, ssao, gbuffer.frame()), disjoint);
  multiResolution_.settings().technique = Technique::full;
  const Picture full = renderPicture(multiResolution_, ssao, gbuffer.frame());
  EXPECT_LT(rootMeanSquare(disjoint, full), 0.02);
  EXPECT_NE(inclusive, disjoint);
}

TEST_F(Disjoint, LeavesTheHostsStateAloneAndAllocatesNothing) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  TestEffect effect(levelNumbers());
  const Picture expected = renderPicture(multiResolution_, effect, gbuffer.frame());
  GLuint result = 0;
  {
    const HostileState hostile;
    const GlState before = captureGlState();
    result = multiResolution_.render(effect, gbuffer.frame());
    EXPECT_THAT(differences(before, captureGlState()), testing::IsEmpty());
  }
  EXPECT_EQ(readPixels(result, size, 1), expected);
  const AllocationCounter allocations;
  multiResolution_.render(effect, gbuffer.frame());
  EXPECT_EQ(allocations.count(), 0u);
}

}  // namespace
}  // namespace mres::test
