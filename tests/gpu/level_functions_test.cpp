// The GLSL functions of level.glsl: which full-resolution pixels a level's pixels are of.
#include <algorithm>
#include <cmath>

#include "mres/gl/uniform_buffer.h"
#include "mres/level/level_targets.h"
#include "tests/support/gl_test.h"
#include "tests/support/glsl_function.h"

namespace mres::test {
namespace {

class LevelFunctions : public GlTest {
 protected:
  std::vector<glm::vec4> evaluateLevel(const std::string& expression, std::span<const glm::vec4> a,
                                       const params::LevelParams& params) {
    return evaluate("#include \"mres/level.glsl\"", expression, a, {}, [&](const gl::Program& program) {
      program.setBlockBinding("LevelParams", 0);
      levelBlock_.upload(params);
      levelBlock_.bind(0);
    });
  }

 private:
  gl::UniformBuffer<params::LevelParams> levelBlock_;
};

std::string inGlsl(glm::ivec2 v) {
  return "ivec2(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ")";
}

/// Pixels along the diagonal, of all four phases of the jitter.
std::vector<glm::vec4> diagonalOf(glm::ivec2 size) {
  std::vector<glm::vec4> pixels;
  for (int i = 0; i < std::max(size.x, size.y); ++i)
    pixels.emplace_back(glm::min(glm::ivec2(i, i + i / 2 % 2), size - 1), 0, 0);
  return pixels;
}

TEST_F(LevelFunctions, LevelPixelsStandForOneFullPixelEach) {
  for (const glm::ivec2 size :
       {glm::ivec2(1), glm::ivec2(31, 17), glm::ivec2(128, 65), glm::ivec2(251, 257)}) {
    for (int index = 0; index < kMaxLevels; ++index) {
      const PlannedLevel level{index, levelSize(size, index), {}};
      const std::vector<glm::vec4> pixels = diagonalOf(level.size);
      for (const bool filtered : {false, true}) {
        const auto values =
            evaluateLevel("vec4(representativePixel(ivec2(a.xy), " + inGlsl(size) + "), 0.0, 0.0)", pixels,
                          levelParams({level, nullptr, filtered}, size, 0.0f));
        for (std::size_t i = 0; i < pixels.size(); ++i) {
          const glm::ivec2 pixel(pixels[i]);
          const int stride = 1 << index;
          const glm::ivec2 turn =
              filtered && index > 0 ? glm::ivec2(pixel.y % 2, pixel.x % 2) : glm::ivec2(0);
          const glm::ivec2 expected = glm::min(pixel * stride + stride / 2 - turn, size - 1);
          ASSERT_EQ(glm::ivec2(values[i]), expected)
              << "level " << index << " of " << size.x << "x" << size.y;
        }
      }
    }
  }
}

TEST_F(LevelFunctions, OddPeriodsHaveNoJitter) {
  for (int period = 1; period <= 4; ++period) {
    const PlannedLevel level{2, glm::ivec2(64), {.noisePeriod = period}};
    EXPECT_EQ(levelParams({level}, glm::ivec2(256), 0.0f).levelJitter, period % 2 == 0 ? 1 : 0) << period;
  }
}

TEST_F(LevelFunctions, CoarserCoordinatesHitTexelCentresAtTheirPixels) {
  for (const glm::ivec2 size : {glm::ivec2(31, 17), glm::ivec2(128, 65), glm::ivec2(251, 257)}) {
    for (int coarse = 1; coarse < kMaxLevels; ++coarse) {
      for (const bool filtered : {false, true}) {
        const PlannedLevel coarser{coarse, levelSize(size, coarse), {}};
        const PlannedLevel level{coarse - 1, levelSize(size, coarse - 1), {}};
        const std::vector<glm::vec4> texels = diagonalOf(coarser.size);
        const auto places = evaluateLevel("vec4(placeOf(ivec2(a.xy), " + inGlsl(size) + "), 0.0, 0.0)",
                                          texels, levelParams({coarser, nullptr, filtered}, size, 0.0f));
        const auto values = evaluateLevel("vec4(coarserCoordinate(a.xy), 0.0, 0.0)", places,
                                          levelParams({level, &coarser, filtered}, size, 0.0f));
        for (std::size_t i = 0; i < texels.size(); ++i) {
          const glm::dvec2 expected = (glm::dvec2(texels[i]) + 0.5) / glm::dvec2(coarser.size);
          ASSERT_LT(glm::distance(glm::dvec2(values[i]), expected), 1e-6) << coarse << ", " << i;
        }
      }
    }
  }
}

TEST_F(LevelFunctions, PlacesAreBlockCentresWithJitterAndPixelsWithout) {
  const glm::ivec2 size(251, 258);
  for (int index = 0; index < kMaxLevels; ++index) {
    const PlannedLevel level{index, levelSize(size, index), {}};
    const std::vector<glm::vec4> pixels = diagonalOf(level.size);
    for (const bool filtered : {false, true}) {
      const auto params = levelParams({level, nullptr, filtered}, size, 0.0f);
      const auto places =
          evaluateLevel("vec4(placeOf(ivec2(a.xy), " + inGlsl(size) + "), 0.0, 0.0)", pixels, params);
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        const glm::dvec2 centre = (glm::dvec2(pixels[i]) + 0.5) * std::exp2(index) - 0.5;
        const glm::dvec2 corner = glm::dvec2(glm::ivec2(pixels[i]) * (1 << index) + (1 << index) / 2);
        const glm::dvec2 expected = glm::min(filtered ? centre : corner, glm::dvec2(size - 1));
        ASSERT_EQ(glm::dvec2(places[i]), expected) << "level " << index;
      }
    }
  }
}

TEST_F(LevelFunctions, MaskCoordinatesAreThoseOfThePixelsPlace) {
  for (const glm::ivec2 size : {glm::ivec2(31, 17), glm::ivec2(128, 65), glm::ivec2(251, 257)}) {
    for (int index = 0; index + 1 < kMaxLevels; ++index) {
      const PlannedLevel level{index, levelSize(size, index), {}};
      std::vector<glm::vec4> pixels;
      pixels.reserve(static_cast<std::size_t>(size.x));
      for (int x = 0; x < size.x; ++x) pixels.emplace_back(x, x % size.y, 0, 0);
      const auto values =
          evaluateLevel("vec4(maskCoordinate(a.xy), 0.0, 0.0)", pixels, levelParams({level}, size, 0.0f));
      const glm::dvec2 maskSize(levelSize(size, index + 1));
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        const glm::dvec2 expected = (glm::dvec2(pixels[i]) + 0.5) / std::exp2(index + 1) / maskSize;
        ASSERT_LT(glm::distance(glm::dvec2(values[i]), expected), 1e-6) << "level " << index;
      }
    }
  }
}

}  // namespace
}  // namespace mres::test
