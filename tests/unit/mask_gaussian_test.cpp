#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "mres/mask/mask_pass.h"

namespace mres {
namespace {

double weightOf(const params::MaskBlurParams& params, int distance) {
  return static_cast<double>(params.weights[distance / 4][distance % 4]);
}

double sumOf(const params::MaskBlurParams& params) {
  double sum = weightOf(params, 0);
  for (int distance = 1; distance <= params.radius; ++distance) sum += 2.0 * weightOf(params, distance);
  return sum;
}

const std::vector<float> kVariances = {0.01f, 0.231f, 0.462f, 0.924f, 1.848f, 3.696f, 8.0f, 16.0f};

TEST(MaskGaussian, VarianceZeroIsTheImageItself) {
  const params::MaskBlurParams params = gaussian(0.0f);
  EXPECT_EQ(params.radius, 0);
  EXPECT_EQ(params.weights[0].x, 1.0f);
}

TEST(MaskGaussian, WeightsSumToOne) {
  for (const float variance : kVariances) EXPECT_NEAR(sumOf(gaussian(variance)), 1.0, 1e-6) << variance;
}

TEST(MaskGaussian, WeightsFollowTheExponential) {
  for (const float variance : kVariances) {
    const params::MaskBlurParams params = gaussian(variance);
    for (int distance = 1; distance <= params.radius; ++distance) {
      const double expected = std::exp(-0.5 * distance * distance / static_cast<double>(variance));
      EXPECT_NEAR(weightOf(params, distance) / weightOf(params, 0), expected, 1e-6) << variance;
    }
  }
}

TEST(MaskGaussian, WhatIsLeftOutWouldRoundToNothing) {
  for (const float variance : kVariances) {
    const params::MaskBlurParams params = gaussian(variance);
    const int next = params.radius + 1;
    if (next > MASK_BLUR_MAX_RADIUS) continue;
    const double left = std::exp(-0.5 * next * next / static_cast<double>(variance)) * weightOf(params, 0);
    EXPECT_LT(left * 255.0, 0.5 + 1e-6) << variance;
    EXPECT_GE(weightOf(params, params.radius) * 255.0, 0.5 - 1e-6) << variance;
  }
}

TEST(MaskGaussian, VarianceIsThatOfTheWeights) {
  for (const float variance : kVariances) {
    if (variance < 0.4f) continue;  // narrower than the texels that sample it
    const params::MaskBlurParams params = gaussian(variance);
    double second = 0.0;
    for (int distance = 1; distance <= params.radius; ++distance) {
      second += 2.0 * distance * distance * weightOf(params, distance);
    }
    EXPECT_NEAR(second / static_cast<double>(variance), 1.0, 0.12) << variance;
  }
}

TEST(MaskGaussian, ExtremeVariancesStayWithinTheBlock) {
  for (const float variance : {1e-30f, 1e-3f, 64.0f, 1e6f, 1e30f}) {
    const params::MaskBlurParams params = gaussian(variance);
    EXPECT_GE(params.radius, 0);
    EXPECT_LE(params.radius, MASK_BLUR_MAX_RADIUS);
    EXPECT_NEAR(sumOf(params), 1.0, 1e-6) << variance;
  }
}

}  // namespace
}  // namespace mres
