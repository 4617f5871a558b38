#include "effects/common/sample_points.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace mres {
namespace {

class SamplePoints : public testing::TestWithParam<int> {};

TEST_P(SamplePoints, LieInTheUnitHemisphereOverTheSurface) {
  for (const int seed : {0, 1, 65535}) {
    const std::vector<glm::vec3> points = hemispherePoints(GetParam(), seed);
    ASSERT_EQ(points.size(), static_cast<std::size_t>(GetParam()));
    for (const glm::vec3 point : points) {
      EXPECT_GE(point.z, 0.0f);
      EXPECT_GE(glm::length(point), 0.999e-3f);
      EXPECT_LE(glm::length(point), 1.0f + 1e-6f);
    }
  }
}

TEST_P(SamplePoints, DistancesAreStratified) {
  std::vector<float> distances;
  for (const glm::vec3 point : hemispherePoints(GetParam(), 3)) distances.push_back(glm::length(point));
  std::ranges::sort(distances);
  const auto count = static_cast<float>(distances.size());
  for (std::size_t i = 0; i < distances.size(); ++i) {
    EXPECT_GE(distances[i], static_cast<float>(i) / count - 1e-5f);
    EXPECT_LE(distances[i], std::max(static_cast<float>(i + 1) / count, 1e-3f) + 1e-5f);
  }
}

INSTANTIATE_TEST_SUITE_P(Counts, SamplePoints, testing::Values(1, 2, 3, 16, 64, 255, 256, 8192));

// Cosine-weighted directions have mean cosine 2/3, mean squared cosine 1/2, and no preferred azimuth.
TEST(SamplePointsDistribution, DirectionsAreCosineWeighted) {
  for (const int seed : {0, 1, 2, 77}) {
    double cosine = 0.0;
    double squaredCosine = 0.0;
    glm::dvec2 sideways(0.0);
    const std::vector<glm::vec3> points = hemispherePoints(256, seed);
    for (const glm::dvec3 point : points) {
      const glm::dvec3 direction = glm::normalize(point);
      cosine += direction.z / 256.0;
      squaredCosine += direction.z * direction.z / 256.0;
      sideways += glm::dvec2(direction) / 256.0;
    }
    EXPECT_NEAR(cosine, 2.0 / 3.0, 0.01);
    EXPECT_NEAR(squaredCosine, 0.5, 0.01);
    EXPECT_LT(glm::length(sideways), 0.03);
  }
}

TEST(SamplePointsDistribution, SameSeedSamePointsOtherSeedOthers) {
  EXPECT_EQ(hemispherePoints(64, 5), hemispherePoints(64, 5));
  EXPECT_NE(hemispherePoints(64, 5), hemispherePoints(64, 6));
}

}  // namespace
}  // namespace mres
