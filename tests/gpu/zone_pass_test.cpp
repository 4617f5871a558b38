// Where levels render: each inside of where the coarser one does.
#include "mres/mask/zone_pass.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "tests/support/gl_test.h"
#include "tests/support/glsl_function.h"
#include "tests/support/mask_bench.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

/// Draws zones as a frame does, coarsest first.
class ZoneBench {
 public:
  ZoneBench(glm::ivec2 fullSize, const LevelTable& table, double edgeDensity, unsigned seed)
      : plan_(planLevels(Technique::multiResolution, table, fullSize)),
        random_(seed),
        zonePass_(shaderLibrary()) {
    edges_ = randomTexture(levelSize(fullSize, 1), edgeDensity);
    static_cast<void>(masks_.masks(edges_, plan_));
  }

  /// The zones of all levels but the coarsest, finest first.
  std::vector<Image> zones(ZoneRule rule) {
    std::vector<Image> zones;
    for (std::size_t i = 0; i + 1 < plan_.levels.size(); ++i) zones.push_back(zone(i, rule));
    return zones;
  }

  [[nodiscard]] const LevelPlan& plan() const { return plan_; }

 private:
  Image zone(std::size_t planned, ZoneRule rule) {
    const PlannedLevel& level = plan_.levels[planned];
    const gl::Texture2D& mask = rule == ZoneRule::mask ? masks_.mask(level.index) : masks_.edges(level.index);
    levelBlock_.upload(levelParams({level, &plan_.levels[planned + 1]}, plan_.levels.front().size, 0.0f));
    levelBlock_.bind(kLevelBlock);
    zonePass_.draw(context_, level, {.rule = rule, .mask = &mask});
    Image zone = readImage(zonePass_.zone(level.index), 1);
    expectLikeReference(zone, readImage(mask, 1), rule);
    return zone;
  }

  /// Expects the zone where the mask is above zero somewhere in the block: for pixels, which see it
  /// bilinearly, or in its own texels.
  static void expectLikeReference(const Image& zone, const Image& mask, ZoneRule rule) {
    constexpr double kTexels = ZONE_BLOCK / 2;
    for (int i = 0; i < zone.size.x * zone.size.y; ++i) {
      const glm::ivec2 texel(i % zone.size.x, i / zone.size.x);
      const glm::dvec2 low = glm::dvec2(texel) * kTexels;
      const bool expected = rule == ZoneRule::mask ? largestIn(mask, low, low + kTexels, 2) > 0.0
                                                   : largestIn(mask, low + 0.5, low + kTexels - 0.5, 2) > 0.0;
      ASSERT_EQ(zone.at(texel), expected ? 1.0f : 0.0f) << "texel " << texel.x << ", " << texel.y;
    }
  }

  gl::Texture2D randomTexture(glm::ivec2 size, double density) {
    std::bernoulli_distribution one(density);
    std::vector<std::uint8_t> texels;
    for (int i = 0; i < size.x * size.y; ++i) texels.push_back(one(random_) ? 255 : 0);
    return {GL_R8, size, "test.random", 1, texels.data()};
  }

  LevelPlan plan_;
  std::mt19937 random_;
  PassContext context_;
  ZonePass zonePass_;
  MaskBench masks_;
  gl::Texture2D edges_;
  gl::UniformBuffer<params::LevelParams> levelBlock_;
};

/// Texels of the finer zone that have no texel of the coarser one over them.
int texelsOutside(const Image& finer, const Image& coarser, int ratio) {
  int outside = 0;
  for (int i = 0; i < finer.size.x * finer.size.y; ++i) {
    const glm::ivec2 texel(i % finer.size.x, i / finer.size.x);
    outside += finer.at(texel) > 0.0f && coarser.at(texel / ratio) == 0.0f ? 1 : 0;
  }
  return outside;
}

class ZonePassTest : public GlTest {
 protected:
  /// Counts texels beyond the coarser level's zone over many plans.
  static void expectContainment(ZoneRule rule) {
    for (unsigned seed = 0; seed < 12; ++seed) {
      const glm::ivec2 fullSize(200 + static_cast<int>(seed) * 7, 150 + static_cast<int>(seed) * 3);
      for (const unsigned levels : {0b1111u, 0b1101u, 0b1011u, 0b0111u}) {
        ZoneBench bench(fullSize, levelSubset(levels), seed % 2 == 0 ? 0.001 : 0.01, seed);
        const std::vector<Image> zones = bench.zones(rule);
        for (std::size_t i = 0; i + 1 < zones.size(); ++i) {
          const int ratio = 1 << (bench.plan().levels[i + 1].index - bench.plan().levels[i].index);
          ASSERT_EQ(texelsOutside(zones[i], zones[i + 1], ratio), 0)
              << "seed " << seed << ", levels " << levels << ", zone " << i;
        }
      }
    }
  }
};

TEST_F(ZonePassTest, ByMasksEachZoneLiesInThatOfTheCoarserLevel) {
  expectContainment(ZoneRule::mask);
}

TEST_F(ZonePassTest, ByEdgesEachZoneLiesInThatOfTheCoarserLevel) {
  expectContainment(ZoneRule::edges);
}

}  // namespace
}  // namespace mres::test
