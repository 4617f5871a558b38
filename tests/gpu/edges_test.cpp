// What is an edge, on G-buffers cast in double precision.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>
#include <utility>

#include "tests/support/gl_test.h"
#include "tests/support/mask_bench.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"

namespace mres::test {
namespace {

constexpr int kNormalChannel = 0;
constexpr int kDepthChannel = 1;

int count(const Image& edges, int channel) {
  int sum = 0;
  for (int y = 0; y < edges.size.y; ++y) {
    for (int x = 0; x < edges.size.x; ++x) sum += edges.at({x, y}, channel) > 0.0f ? 1 : 0;
  }
  return sum;
}

/// Whether some texel of every row of the edge image is an edge.
bool everyRowHasAnEdge(const Image& edges, int channel) {
  for (int y = 0; y < edges.size.y; ++y) {
    bool found = false;
    for (int x = 0; x < edges.size.x; ++x) found |= edges.at({x, y}, channel) > 0.0f;
    if (!found) return false;
  }
  return true;
}

/// The left half shows one scene, the right half another. Perspective only.
RayCaster splitScreen(RayCaster left, RayCaster right) {
  return [left = std::move(left), right = std::move(right)](glm::dvec3 origin, glm::dvec3 direction) {
    return origin.x + direction.x < 0.0 ? left(origin, direction) : right(origin, direction);
  };
}

RayCaster facingPlane(double depth) {
  return plane({0.0, 0.0, 1.0}, -depth);
}

RayCaster withNormal(RayCaster scene, glm::dvec3 normal) {
  return [scene = std::move(scene), normal](glm::dvec3 origin, glm::dvec3 direction) {
    std::optional<Hit> hit = scene(origin, direction);
    if (hit) hit->normal = normal;
    return hit;
  };
}

RayCaster sky() {
  return [](glm::dvec3, glm::dvec3) { return std::optional<Hit>(); };
}

/// A plane through (0, 0, -depth), tilted by an angle off the viewing direction about a random axis.
RayCaster tiltedPlane(double depth, double tiltDegrees, double azimuth) {
  const double tilt = glm::radians(tiltDegrees);
  const glm::dvec3 normal(std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth),
                          std::cos(tilt));
  return plane(normal, glm::dot(normal, glm::dvec3(0.0, 0.0, -depth)));
}

/// Edges where all pixels around are surface (a tilted plane may end at its horizon).
int countAwayFromBackground(const Image& edges, const SyntheticGBuffer& gbuffer) {
  const glm::ivec2 size = gbuffer.frame().size;
  int sum = 0;
  for (int y = 0; y < edges.size.y; ++y) {
    for (int x = 0; x < edges.size.x; ++x) {
      bool surface = true;
      for (int j = -3; j <= 3; ++j) {
        for (int i = -3; i <= 3; ++i) {
          const glm::ivec2 pixel = glm::clamp(glm::ivec2(2 * x + i, 2 * y + j), glm::ivec2(0), size - 1);
          const float depth = gbuffer.depths()[static_cast<std::size_t>(pixel.y * size.x + pixel.x)];
          surface &= depth > 0.0f && depth < 1.0f;
        }
      }
      const bool edge = edges.at({x, y}, kNormalChannel) + edges.at({x, y}, kDepthChannel) > 0.0f;
      sum += surface && edge ? 1 : 0;
    }
  }
  return sum;
}

class Edges : public GlTest {
 protected:
  int planeEdges(glm::ivec2 size, const glm::mat4& projection, const RayCaster& scene,
                 const DepthStorage& storage, const MaskSettings& settings = {}) {
    const SyntheticGBuffer gbuffer(size, projection, scene, storage);
    return countAwayFromBackground(bench_.edges(gbuffer.frame(), settings), gbuffer);
  }

  MaskBench bench_;
};

const std::vector<DepthStorage> kStorages = {
    {GL_DEPTH_COMPONENT32F}, {GL_DEPTH_COMPONENT24}, {GL_DEPTH_COMPONENT16}};

TEST_F(Edges, APlaneAtAnyAngleHasNoneInPerspective) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> random(0.0, 1.0);
  const glm::ivec2 size(97, 63);
  for (int i = 0; i < 40; ++i) {
    const double tilt = i % 4 == 0 ? 89.5 * random(generator) : 80.0 + 9.5 * random(generator);
    const double depth = std::exp(random(generator) * 4.0 - 1.0);
    const auto fov = static_cast<float>(15.0 + 90.0 * random(generator));
    const RayCaster scene = tiltedPlane(depth, tilt, 6.3 * random(generator));
    for (const DepthStorage& storage : kStorages) {
      ASSERT_EQ(planeEdges(size, perspective(size, fov), scene, storage), 0)
          << "tilt " << tilt << ", depth " << depth << ", field of view " << fov << ", format "
          << storage.format;
    }
  }
}

TEST_F(Edges, APlaneAtAnyAngleHasNoneInOrthographicViews) {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> random(0.0, 1.0);
  const glm::ivec2 size(97, 63);
  const glm::mat4 projection = glm::ortho(-3.0f, 3.0f, -2.0f, 2.0f, 0.1f, 100.0f);
  for (int i = 0; i < 20; ++i) {
    const double tilt = i % 2 == 0 ? 89.5 * random(generator) : 85.0 + 4.5 * random(generator);
    const RayCaster scene = tiltedPlane(50.0, tilt, 6.3 * random(generator));
    for (const DepthStorage& storage : kStorages) {
      ASSERT_EQ(planeEdges(size, projection, scene, storage), 0)
          << "tilt " << tilt << ", format " << storage.format;
    }
  }
}

TEST_F(Edges, APlaneHasNoneAtTheStrictestThresholds) {
  const glm::ivec2 size(97, 63);
  const MaskSettings strict{.normalThreshold = 0.5f, .depthThreshold = 0.0f};
  for (const double tilt : {0.0, 45.0, 80.0, 89.5}) {
    for (const DepthStorage& storage : kStorages) {
      EXPECT_EQ(planeEdges(size, perspective(size), tiltedPlane(3.0, tilt, 0.7), storage, strict), 0)
          << "tilt " << tilt << ", format " << storage.format;
    }
  }
}

TEST_F(Edges, APlaneHasNoneWithReversedDepth) {
  const glm::ivec2 size(97, 63);
  glm::mat4 projection(0.0f);  // infinite far plane at window depth 0
  projection[0][0] = projection[1][1] = 1.5f;
  projection[2][3] = -1.0f;
  projection[3][2] = 0.1f;
  for (const double tilt : {0.0, 45.0, 80.0, 89.5}) {
    EXPECT_EQ(planeEdges(size, projection, tiltedPlane(20.0, tilt, 0.7),
                         {GL_DEPTH_COMPONENT32F, ClipDepth::zeroToOne, true}),
              0)
        << "tilt " << tilt;
  }
}

TEST_F(Edges, TheThresholdIsTheSameStepAtEveryDistanceResolutionAndFieldOfView) {
  for (const glm::ivec2 size : {glm::ivec2(64, 16), glm::ivec2(160, 16), glm::ivec2(321, 17)}) {
    for (const float fov : {20.0f, 60.0f, 110.0f}) {
      for (const double depth : {0.3, 1.0, 5.0, 20.0}) {
        for (const float threshold : {0.05f, 0.5f}) {
          const MaskSettings settings{.depthThreshold = threshold};
          const auto edgesOfStep = [&](double step) {
            const SyntheticGBuffer gbuffer(
                size, perspective(size, fov),
                splitScreen(facingPlane(depth), facingPlane(depth + step * static_cast<double>(threshold))));
            return bench_.edges(gbuffer.frame(), settings);
          };
          ASSERT_TRUE(everyRowHasAnEdge(edgesOfStep(1.15), kDepthChannel))
              << size.x << " wide, " << fov << " degrees, " << depth << " m, threshold " << threshold;
          ASSERT_EQ(count(edgesOfStep(0.85), kDepthChannel), 0)
              << size.x << " wide, " << fov << " degrees, " << depth << " m, threshold " << threshold;
        }
      }
    }
  }
}

TEST_F(Edges, TheThresholdIsTheSameStepInOrthographicViews) {
  const glm::ivec2 size(64, 16);
  const glm::mat4 projection = glm::ortho(-3.0f, 3.0f, -2.0f, 2.0f, 0.0f, 50.0f);
  const auto edgesOfStep = [&](double step) {
    const auto split = [step](glm::dvec3 origin, glm::dvec3 direction) {
      return facingPlane(origin.x < 0.0 ? 10.0 : 10.0 + step)(origin, direction);
    };
    const SyntheticGBuffer gbuffer(size, projection, split);
    return bench_.edges(gbuffer.frame());
  };
  EXPECT_TRUE(everyRowHasAnEdge(edgesOfStep(0.0525), kDepthChannel));
  EXPECT_EQ(count(edgesOfStep(0.0475), kDepthChannel), 0);
}

TEST_F(Edges, TheBorderOfTheSkyIsOneAndTheSkyIsNot) {
  const glm::ivec2 size(65, 33);
  EXPECT_EQ(count(bench_.edges(SyntheticGBuffer(size, perspective(size), sky()).frame()), kDepthChannel), 0);
  EXPECT_EQ(count(bench_.edges(SyntheticGBuffer(size, perspective(size), sky()).frame()), kNormalChannel), 0);
  for (const double depth : {0.15, 1.0, 30.0}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), splitScreen(facingPlane(depth), sky()));
    for (const float threshold : {0.05f, 1.0f}) {
      const Image edges = bench_.edges(gbuffer.frame(), {.depthThreshold = threshold});
      EXPECT_TRUE(everyRowHasAnEdge(edges, kDepthChannel)) << depth << " m, threshold " << threshold;
      EXPECT_LE(count(edges, kDepthChannel), 2 * edges.size.y) << "only at the border";
    }
  }
}

TEST_F(Edges, ACreaseOverTheNormalThresholdIsOne) {
  const glm::ivec2 size(65, 33);
  for (const float threshold : {5.0f, 20.0f, 60.0f, 120.0f}) {
    const auto edgesOfCrease = [&](double degrees) {
      const double half = glm::radians(degrees) / 2.0;
      const SyntheticGBuffer gbuffer(
          size, perspective(size),
          splitScreen(withNormal(facingPlane(3.0), {-std::sin(half), 0.0, std::cos(half)}),
                      withNormal(facingPlane(3.0), {std::sin(half), 0.0, std::cos(half)})));
      return bench_.edges(gbuffer.frame(), {.normalThreshold = threshold});
    };
    EXPECT_TRUE(everyRowHasAnEdge(edgesOfCrease(static_cast<double>(threshold) + 0.5), kNormalChannel))
        << threshold;
    EXPECT_EQ(count(edgesOfCrease(static_cast<double>(threshold) - 0.5), kNormalChannel), 0) << threshold;
  }
}

TEST_F(Edges, ACreaseBetweenTwoTexelsIsInBoth) {
  const glm::ivec2 size(64, 64);
  for (const bool vertical : {false, true}) {
    const auto crease = [&](glm::dvec3 origin, glm::dvec3 direction) {
      const double side = (vertical ? direction.y : direction.x) < 0.0 ? -1.0 : 1.0;
      return withNormal(facingPlane(3.0), glm::normalize(glm::dvec3(side, 0.0, 1.0)))(origin, direction);
    };
    const Image edges = bench_.edges(SyntheticGBuffer(size, perspective(size), crease).frame());
    for (int i = 0; i < edges.size.x; ++i) {
      for (const int beside : {15, 16}) {
        const glm::ivec2 texel = vertical ? glm::ivec2(i, beside) : glm::ivec2(beside, i);
        EXPECT_GT(edges.at(texel, kNormalChannel), 0.0f) << texel.x << ", " << texel.y;
      }
    }
    EXPECT_EQ(count(edges, kNormalChannel), 2 * edges.size.x);
  }
}

TEST_F(Edges, EveryPositionOfAStepIsFound) {
  const glm::ivec2 size(21, 19);
  for (int border = 1; border < size.x; ++border) {
    for (const bool vertical : {false, true}) {
      if (vertical && border >= size.y) continue;
      const auto scene = [&](glm::dvec3 origin, glm::dvec3 direction) {
        const glm::dmat4 p(perspective(size));
        const double pixel = vertical ? (direction.y * p[1][1] + 1.0) * 0.5 * size.y
                                      : (direction.x * p[0][0] + 1.0) * 0.5 * size.x;
        return facingPlane(pixel < border ? 3.0 : 4.0)(origin, direction);
      };
      const SyntheticGBuffer gbuffer(size, perspective(size), scene);
      const Image edges = bench_.edges(gbuffer.frame());
      const int lines = vertical ? edges.size.x : edges.size.y;
      EXPECT_GE(count(edges, kDepthChannel), lines) << (vertical ? "row " : "column ") << border;
      EXPECT_LE(count(edges, kDepthChannel), 3 * lines) << (vertical ? "row " : "column ") << border;
    }
  }
}

double degreesBetween(const SyntheticGBuffer& gbuffer, glm::ivec2 a, glm::ivec2 b) {
  const auto at = [&](glm::ivec2 pixel) {
    const glm::ivec2 size = gbuffer.frame().size;
    const glm::ivec2 inside = glm::clamp(pixel, glm::ivec2(0), size - 1);
    return glm::dvec3(gbuffer.normals().at(static_cast<std::size_t>(inside.y * size.x + inside.x)));
  };
  return glm::degrees(std::acos(std::clamp(glm::dot(at(a), at(b)), -1.0, 1.0)));
}

double widestTurn(const SyntheticGBuffer& gbuffer, glm::ivec2 pixel, int distance) {
  double most = 0.0;
  for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)})
    most = std::max(most, degreesBetween(gbuffer, pixel, pixel + distance * step));
  return most;
}

TEST_F(Edges, FoldsAreWhereNormalsTurnBetweenThePixelsOfTheNextCoarserLevel) {
  const glm::ivec2 size(259, 67);
  const double metresPerPixel = 10.0 / (static_cast<double>(perspective(size)[1][1]) * size.y);
  for (const auto& [level, coarser] : {std::pair(1, 2), std::pair(1, 3), std::pair(2, 3)}) {
    SCOPED_TRACE(testing::Message() << "level " << level << ", coarser " << coarser);
    const int texel = 2 << level;
    const int stride = 1 << coarser;
    // Pixels of the coarser level turn by 30 degrees where the curtain turns most, by 13 where it turns
    // least.
    const SyntheticGBuffer gbuffer(size, perspective(size),
                                   curtain(5.0, 7.5 * stride * metresPerPixel, 40.0));
    EXPECT_EQ(count(bench_.edges(gbuffer.frame()), kNormalChannel), 0) << "from pixel to pixel it is smooth";
    const Image folds = bench_.folds(level, coarser, size);
    ASSERT_EQ(folds.size, levelSize(size, level + 1));
    int found = 0;
    for (int i = 0; i < folds.size.x * folds.size.y; ++i) {
      const glm::ivec2 at(i % folds.size.x, i / folds.size.x);
      const double most = widestTurn(gbuffer, glm::min(at * texel + texel / 2, size - 1), stride);
      if (std::abs(most - 20.0) < 0.1) continue;  // within rounding of the threshold
      ASSERT_EQ(folds.at(at), most > 20.0 ? 1.0f : 0.0f) << at.x << ", " << at.y;
      found += most > 20.0 ? 1 : 0;
    }
    EXPECT_GT(found, folds.size.x * folds.size.y / 4);
    EXPECT_LT(found, folds.size.x * folds.size.y * 9 / 10);
  }
}

TEST_F(Edges, TheSkyHasNoFolds) {
  const glm::ivec2 size(128, 96);
  const SyntheticGBuffer gbuffer(size, perspective(size), splitScreen(facingPlane(5.0), sky()));
  static_cast<void>(bench_.edges(gbuffer.frame()));
  const Image folds = bench_.folds(2, 3, size);
  EXPECT_EQ(count(folds, 0), 0);
}

}  // namespace
}  // namespace mres::test
