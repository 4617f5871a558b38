// Masks from edge images: the Gaussian, the down-sampling, and zones that contain one another.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "tests/support/gl_test.h"
#include "tests/support/mask_bench.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

constexpr double kByte = 1.0 / 255.0;

/// Random edges: channel 0 and 1 are 0 or 255.
gl::Texture2D randomEdges(glm::ivec2 size, double density, unsigned seed) {
  std::mt19937 generator(seed);
  std::bernoulli_distribution edge(density);
  std::vector<std::uint8_t> texels(static_cast<std::size_t>(2 * size.x * size.y));
  for (std::uint8_t& texel : texels) texel = edge(generator) ? 255 : 0;
  return {GL_RG8, size, "test.edges", 1, texels.data()};
}

Image combined(const Image& edges) {
  Image image{edges.size, 1, {}};
  for (int y = 0; y < edges.size.y; ++y) {
    for (int x = 0; x < edges.size.x; ++x) {
      image.texels.push_back(std::max(edges.at({x, y}, 0), edges.at({x, y}, 1)));
    }
  }
  return image;
}

float clampedAt(const Image& image, glm::ivec2 texel) {
  return image.at(glm::clamp(texel, glm::ivec2(0), image.size - 1));
}

Image halved(const Image& image) {
  Image half{(image.size + 1) / 2, 1, {}};
  for (int y = 0; y < half.size.y; ++y) {
    for (int x = 0; x < half.size.x; ++x) {
      float largest = 0.0f;
      for (int i = 0; i < 4; ++i) {
        largest = std::max(largest, clampedAt(image, {2 * x + i % 2, 2 * y + i / 2}));
      }
      half.texels.push_back(largest);
    }
  }
  return half;
}

/// The Gaussian of a variance in texels^2, cut off far out, as a sum over both axes in double precision.
double gaussianAt(const Image& image, glm::ivec2 texel, double variance) {
  if (variance == 0.0) return static_cast<double>(clampedAt(image, texel));
  const int reach = static_cast<int>(std::ceil(5.0 * std::sqrt(variance)));
  double sum = 0.0;
  double weights = 0.0;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const double weight = std::exp(-0.5 * (x * x + y * y) / variance);
      sum += weight * static_cast<double>(clampedAt(image, texel + glm::ivec2(x, y)));
      weights += weight;
    }
  }
  return sum / weights;
}

LevelPlan planOf(glm::ivec2 fullSize, const LevelTable& table) {
  return planLevels(Technique::multiResolution, table, fullSize);
}

class Masks : public GlTest {
 protected:
  MaskBench bench_;
};

TEST_F(Masks, AreGaussiansOfTheDownsampledEdges) {
  for (const glm::ivec2 fullSize : {glm::ivec2(64, 64), glm::ivec2(129, 77)}) {
    const gl::Texture2D edges = randomEdges(levelSize(fullSize, 1), 0.03, 5);
    const LevelPlan plan = planOf(fullSize, kSsaoLevels);
    const std::vector<Image> masks = bench_.masks(edges, plan);
    Image source = combined(readImage(edges, 2));
    for (std::size_t i = 0; i < masks.size(); ++i) {
      ASSERT_EQ(masks[i].size, levelSize(fullSize, static_cast<int>(i) + 1));
      const double variance = static_cast<double>(kSsaoLevels.at(i).maskVariance) / 4.0;
      for (int y = 0; y < masks[i].size.y; ++y) {
        for (int x = 0; x < masks[i].size.x; ++x) {
          double expected = gaussianAt(source, {x, y}, variance);
          if (i > 0) {  // a finer zone below keeps the mask up
            for (int k = 0; k < 4; ++k) {
              const bool inFiner = clampedAt(masks[i - 1], {2 * x + k % 2, 2 * y + k / 2}) > 0.0f;
              expected = inFiner ? std::max(expected, static_cast<double>(masks[i].at({x, y}))) : expected;
            }
          }
          ASSERT_NEAR(static_cast<double>(masks[i].at({x, y})), expected, 2.5 * kByte)
              << "level " << i << " at " << x << ", " << y;
        }
      }
      source = halved(source);
    }
  }
}

TEST_F(Masks, OfNoEdgesAreEmptyAndOfEdgesEverywhereAreFull) {
  const glm::ivec2 fullSize(97, 65);
  for (const double density : {0.0, 1.0}) {
    const gl::Texture2D edges = randomEdges(levelSize(fullSize, 1), density, 1);
    for (const Image& mask : bench_.masks(edges, planOf(fullSize, kSsaoLevels))) {
      for (const float texel : mask.texels) ASSERT_EQ(texel, static_cast<float>(density));
    }
  }
}

/// Texels of a finer mask that are above zero while the coarser texel over them is not.
int texelsOutside(const Image& finer, const Image& coarser) {
  const int ratio = (finer.size.x + coarser.size.x - 1) / coarser.size.x;
  int outside = 0;
  for (int y = 0; y < finer.size.y; ++y) {
    for (int x = 0; x < finer.size.x; ++x) {
      outside += finer.at({x, y}) > 0.0f && coarser.at(glm::ivec2(x, y) / ratio) <= 0.0f ? 1 : 0;
    }
  }
  return outside;
}

TEST_F(Masks, ContainThoseOfFinerLevelsWhateverTheVariances) {
  std::mt19937 generator(3);
  constexpr std::array<float, 5> kVariances = {0.0f, 0.3f, 2.0f, 16.0f, 64.0f};
  for (int i = 0; i < 40; ++i) {
    const glm::ivec2 fullSize(65 + static_cast<int>(generator() % 80),
                              64 + static_cast<int>(generator() % 80));
    LevelTable table =
        levelSubset(generator() % 2 == 0 ? 0b1111u : 0b1001u | (generator() % 2 == 0 ? 4u : 2u));
    for (LevelSettings& level : table) level.maskVariance = kVariances.at(generator() % kVariances.size());
    const gl::Texture2D edges =
        randomEdges(levelSize(fullSize, 1), i % 2 == 0 ? 0.002 : 0.02, static_cast<unsigned>(i));
    const std::vector<Image> masks = bench_.masks(edges, planOf(fullSize, table));
    for (std::size_t finer = 0; finer < masks.size(); ++finer) {
      for (std::size_t coarser = finer + 1; coarser < masks.size(); ++coarser) {
        ASSERT_EQ(texelsOutside(masks[finer], masks[coarser]), 0) << "case " << i << ", mask " << finer;
      }
    }
  }
}

TEST_F(Masks, CoverEveryEdgeAtEveryVariance) {
  const glm::ivec2 fullSize(96, 64);
  const gl::Texture2D edges = randomEdges(levelSize(fullSize, 1), 0.002, 9);
  const Image source = combined(readImage(edges, 2));
  for (const float variance : {0.0f, 0.5f, 4.0f, 20.0f, 64.0f}) {
    LevelTable table = kSsaoLevels;
    table[0].maskVariance = variance;
    EXPECT_EQ(texelsOutside(source, bench_.masks(edges, planOf(fullSize, table))[0]), 0) << variance;
  }
}

TEST_F(Masks, MeanTheSameForCreasesAndSteps) {
  const glm::ivec2 fullSize(64, 64);
  std::vector<std::uint8_t> red(32 * 32 * 2, 0);
  red[2 * (32 * 16 + 16)] = 255;
  std::vector<std::uint8_t> green(32 * 32 * 2, 0);
  green[2 * (32 * 16 + 16) + 1] = 255;
  const gl::Texture2D creases(GL_RG8, {32, 32}, "test.creases", 1, red.data());
  const gl::Texture2D steps(GL_RG8, {32, 32}, "test.steps", 1, green.data());
  const auto ofCreases = bench_.masks(creases, planOf(fullSize, kSsaoLevels));
  const auto ofSteps = bench_.masks(steps, planOf(fullSize, kSsaoLevels));
  for (std::size_t i = 0; i < ofSteps.size(); ++i) EXPECT_EQ(ofCreases[i].texels, ofSteps[i].texels);
}

class Zones : public GlTest {};

TEST_F(Zones, PixelsFarFromEdgesShowTheCoarsestLevelAndEdgesTheFinest) {
  const glm::ivec2 size(193, 129);
  const SyntheticGBuffer gbuffer(
      size, perspective(size),
      nearest({plane({0.0, 0.0, 1.0}, -6.0), box({-0.2, -0.2, -5.0}, {0.2, 0.2, -4.0})}));
  for (const unsigned levels : {0b1111u, 0b1101u, 0b1011u, 0b0011u, 0b1001u}) {
    MultiResolution multiResolution;
    refineByMasks(multiResolution);
    TestEffect effect(levelNumbers(levelSubset(levels)));
    const Image picture{size, 1, renderPicture(multiResolution, effect, gbuffer.frame())};
    const float coarsest = (levels & 8u) != 0 ? 0.75f : 0.25f;
    EXPECT_EQ(picture.at({0, 0}), coarsest) << levels;
    EXPECT_EQ(picture.at(size - 1), coarsest) << levels;
    EXPECT_EQ(picture.at({5, size.y / 2}), coarsest) << levels;
    EXPECT_NEAR(*std::ranges::min_element(picture.texels), 0.0f, 1e-3f) << levels;
  }
}

TEST_F(Zones, WithoutEdgesAreNowhere) {
  const glm::ivec2 size(193, 129);
  const SyntheticGBuffer gbuffer(size, perspective(size), plane({0.3, 0.2, 1.0}, -6.0));
  MultiResolution multiResolution;
  TestEffect effect(levelNumbers(kSsaoLevels));
  for (const float value : renderPicture(multiResolution, effect, gbuffer.frame())) ASSERT_EQ(value, 0.75f);
}

}  // namespace
}  // namespace mres::test
