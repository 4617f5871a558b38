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
    edges_ = randomTexture(levelSize(fullSize, 1), edgeDensity, {});
    static_cast<void>(masks_.masks(edges_, plan_));
  }

  /// The zones of all levels but the coarsest, finest first. With `progressive`, the level before the finest
  /// says at random where to refine, within its own zone as the composite pass does.
  std::vector<Image> zones(bool progressive) {
    std::vector<Image> zones(plan_.levels.size() - 1);
    gl::Texture2D refine;
    for (std::size_t i = zones.size(); i-- > 0;) {
      const bool hasSay = progressive && i == 0 && zones.size() > 1;
      zones[i] = zone(i, hasSay ? &refine : nullptr);
      refine = randomTexture(plan_.levels[i].size, 0.3, zones[i]);
    }
    return zones;
  }

  [[nodiscard]] const LevelPlan& plan() const { return plan_; }

 private:
  Image zone(std::size_t planned, const gl::Texture2D* refine) {
    const PlannedLevel& level = plan_.levels[planned];
    const LevelNeighbours neighbours{level, &plan_.levels[planned + 1]};
    levelBlock_.upload(levelParams(neighbours, plan_.levels.front().size, 0.0f));
    levelBlock_.bind(kLevelBlock);
    zonePass_.draw(context_, level, {.mask = &masks_.mask(level.index), .refine = refine});
    Image zone = readImage(zonePass_.zone(level.index), 1);
    expectLikeReference(zone, neighbours, refine);
    return zone;
  }

  /// Expects the zone where the mask and the coarser level's say are above zero somewhere in the block.
  void expectLikeReference(const Image& zone, const LevelNeighbours& level,
                           const gl::Texture2D* refine) const {
    const Image mask = readImage(masks_.mask(level.level.index), 1);
    const Image say = refine == nullptr ? Image{{1, 1}, 1, {1.0f}} : readImage(*refine, 1);
    const double stride = std::exp2(level.level.index);
    const double coarserStride = std::exp2(level.coarser->index);
    for (int i = 0; i < zone.size.x * zone.size.y; ++i) {
      const glm::ivec2 texel(i % zone.size.x, i / zone.size.x);
      const glm::dvec2 low = glm::dvec2(texel * ZONE_BLOCK) * stride;
      const glm::dvec2 high = low + ZONE_BLOCK * stride;
      const bool masked = largestIn(mask, low / (2.0 * stride), high / (2.0 * stride), 2) > 0.0;
      const bool refined = largestIn(say, low / coarserStride, high / coarserStride, 2) > 0.0;
      ASSERT_EQ(zone.at(texel), masked && refined ? 1.0f : 0.0f)
          << "level " << level.level.index << ", texel " << texel.x << ", " << texel.y;
    }
  }

  /// 0 or 1 at random, 0 outside of a zone (where there is one).
  gl::Texture2D randomTexture(glm::ivec2 size, double density, const Image& zone) {
    std::bernoulli_distribution one(density);
    std::vector<std::uint8_t> texels;
    for (int i = 0; i < size.x * size.y; ++i) {
      const glm::ivec2 pixel(i % size.x, i / size.x);
      const bool inside = zone.texels.empty() || zone.at(pixel / ZONE_BLOCK) > 0.0f;
      texels.push_back(inside && one(random_) ? 255 : 0);
    }
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

bool isOn(const Image& zone, glm::ivec2 texel) {
  return zone.at(glm::clamp(texel, glm::ivec2(0), zone.size - 1)) > 0.0f;
}

/// Texels of the finer zone that have no texel of the coarser one over them or, with a reach of 1, over a
/// neighbour.
int texelsOutside(const Image& finer, const Image& coarser, int ratio, int reach) {
  int outside = 0;
  for (int i = 0; i < finer.size.x * finer.size.y; ++i) {
    const glm::ivec2 texel(i % finer.size.x, i / finer.size.x);
    bool inside = false;
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        const glm::ivec2 near = glm::clamp(texel + glm::ivec2(x, y), glm::ivec2(0), finer.size - 1);
        inside |= isOn(coarser, near / ratio);
      }
    }
    outside += isOn(finer, texel) && !inside ? 1 : 0;
  }
  return outside;
}

class ZonePassTest : public GlTest {
 protected:
  /// Counts texels beyond the coarser level's zone over many plans.
  static void expectContainment(bool progressive, int reach) {
    for (unsigned seed = 0; seed < 12; ++seed) {
      const glm::ivec2 fullSize(200 + static_cast<int>(seed) * 7, 150 + static_cast<int>(seed) * 3);
      for (const unsigned levels : {0b1111u, 0b1101u, 0b1011u, 0b0111u}) {
        ZoneBench bench(fullSize, levelSubset(levels), seed % 2 == 0 ? 0.001 : 0.01, seed);
        const std::vector<Image> zones = bench.zones(progressive);
        for (std::size_t i = 0; i + 1 < zones.size(); ++i) {
          const int ratio = 1 << (bench.plan().levels[i + 1].index - bench.plan().levels[i].index);
          ASSERT_EQ(texelsOutside(zones[i], zones[i + 1], ratio, reach), 0)
              << "seed " << seed << ", levels " << levels << ", zone " << i;
        }
      }
    }
  }
};

TEST_F(ZonePassTest, ByMasksAloneEachZoneLiesInThatOfTheCoarserLevel) {
  expectContainment(false, 0);
}

TEST_F(ZonePassTest, ProgressivelyEachZoneEndsATexelBeyondThatOfTheCoarserLevelAtMost) {
  expectContainment(true, 1);
}

}  // namespace
}  // namespace mres::test
