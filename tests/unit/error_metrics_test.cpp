#include "host/measure/error_metrics.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <stdexcept>

namespace host {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

FloatImage makeImage(glm::ivec2 size, const std::function<float(int, int)>& value) {
  FloatImage image{size, 1, {}};
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) image.pixels.push_back(value(x, y));
  return image;
}

FloatImage noise(glm::ivec2 size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
  return makeImage(size, [&](int, int) { return uniform(random); });
}

/// SSIM straight from the paper's equations 13 to 16: every window in two dimensions, nothing separated.
double plainSimilarity(const FloatImage& a, const FloatImage& b) {
  double sum = 0.0;
  int windows = 0;
  for (int cy = 5; cy < a.size.y - 5; ++cy) {
    for (int cx = 5; cx < a.size.x - 5; ++cx, ++windows) {
      double weightSum = 0.0, ma = 0.0, mb = 0.0;
      const auto forWindow = [&](const std::function<void(double, double, double)>& visit) {
        for (int y = -5; y <= 5; ++y)
          for (int x = -5; x <= 5; ++x) {
            const int index = (cy + y) * a.size.x + cx + x;
            visit(std::exp(-(x * x + y * y) / 4.5), a.pixels[index], b.pixels[index]);
          }
      };
      forWindow([&](double w, double va, double vb) { weightSum += w, ma += w * va, mb += w * vb; });
      ma /= weightSum, mb /= weightSum;
      double saa = 0.0, sbb = 0.0, sab = 0.0;
      forWindow([&](double w, double va, double vb) {
        w /= weightSum;
        saa += w * (va - ma) * (va - ma), sbb += w * (vb - mb) * (vb - mb), sab += w * (va - ma) * (vb - mb);
      });
      sum += (2.0 * ma * mb + 1e-4) * (2.0 * sab + 9e-4) / ((ma * ma + mb * mb + 1e-4) * (saa + sbb + 9e-4));
    }
  }
  return sum / windows;
}

TEST(ErrorMetrics, OfEqualImagesAreNone) {
  const FloatImage image = noise({33, 21}, 1);
  const ErrorMetrics metrics = compareImages(image, image);
  EXPECT_EQ(metrics.rms, 0.0);
  EXPECT_EQ(metrics.max, 0.0);
  EXPECT_TRUE(std::isinf(metrics.psnr));
  EXPECT_NEAR(metrics.ssim, 1.0, 1e-12);
  EXPECT_EQ(metrics.nonFinite, 0);
}

TEST(ErrorMetrics, OfAConstantOffsetAreThatOffset) {
  const auto gray = [](float value) { return makeImage({40, 30}, [=](int, int) { return value; }); };
  const ErrorMetrics metrics = compareImages(gray(0.75f), gray(0.5f));
  EXPECT_DOUBLE_EQ(metrics.rms, 0.25);
  EXPECT_DOUBLE_EQ(metrics.max, 0.25);
  EXPECT_NEAR(metrics.psnr, 12.0412, 1e-4);
  EXPECT_NEAR(metrics.ssim, (2 * 0.75 * 0.5 + 1e-4) / (0.75 * 0.75 + 0.25 + 1e-4), 1e-9);
}

TEST(ErrorMetrics, MaximumFindsTheOneWrongPixel) {
  const FloatImage reference = makeImage({64, 64}, [](int, int) { return 0.5f; });
  FloatImage image = reference;
  image.pixels[64 * 40 + 7] = 0.9f;
  const ErrorMetrics metrics = compareImages(image, reference);
  EXPECT_NEAR(metrics.max, 0.4, 1e-7);
  EXPECT_NEAR(metrics.rms, 0.4 / 64.0, 1e-7);
}

TEST(BlockErrors, FindTheWorstBlockAlsoWhereItIsCutOff) {
  const FloatImage reference = makeImage({37, 21}, [](int, int) { return 0.5f; });
  for (const glm::ivec2 corner : {glm::ivec2(0, 0), {16, 8}, {32, 8}, {8, 16}, {32, 16}}) {
    const glm::ivec2 end = glm::min(corner + 8, reference.size);
    const auto isIn = [&](int x, int y) { return x >= corner.x && y >= corner.y && x < end.x && y < end.y; };
    const FloatImage image =
        makeImage(reference.size, [&](int x, int y) { return isIn(x, y) ? 0.7f : 0.55f; });
    const BlockErrors errors = compareBlocks(image, reference);
    EXPECT_NEAR(errors.max, 0.2, 1e-7);
    EXPECT_TRUE(isIn(errors.worst.x, errors.worst.y)) << errors.worst.x << ", " << errors.worst.y;
  }
}

TEST(BlockErrors, NinetyNineOfAHundredBlocksDoNotExceedThePercentile) {
  const FloatImage reference = makeImage({80, 80}, [](int, int) { return 0.0f; });
  const FloatImage image =
      makeImage({80, 80}, [](int x, int y) { return static_cast<float>(y / 8 * 10 + x / 8 + 1) / 100.0f; });
  const BlockErrors errors = compareBlocks(image, reference);
  EXPECT_NEAR(errors.max, 1.0, 1e-6);
  EXPECT_NEAR(errors.percentile99, 0.99, 0.0101);
  EXPECT_LT(errors.percentile99, errors.max);
  EXPECT_EQ(errors.worst, glm::ivec2(76));
}

TEST(BlockErrors, CountEveryChannelAndWhatIsNotANumber) {
  const FloatImage reference{{8, 8}, 3, std::vector<float>(8 * 8 * 3, 0.5f)};
  FloatImage image = reference;
  for (int i = 0; i < 48; ++i) image.pixels[i] = kNaN;
  EXPECT_NEAR(compareBlocks(image, reference).max, 0.5, 1e-12);
  EXPECT_EQ(compareImages(image, reference).blocks.max, compareBlocks(image, reference).max);
}

TEST(ErrorMetrics, ErrorsBelowEightBitsAreNotLost) {
  const FloatImage reference = makeImage({16, 16}, [](int, int) { return 0.5f; });
  const FloatImage image = makeImage({16, 16}, [](int, int) { return 0.50001f; });
  EXPECT_NEAR(compareImages(image, reference).rms, 1e-5, 1e-7);
}

TEST(ErrorMetrics, ANonFiniteValueIsAnErrorOfOne) {
  const FloatImage reference = makeImage({20, 20}, [](int, int) { return 0.5f; });
  FloatImage image = reference;
  image.pixels[30] = kNaN;
  image.pixels[31] = std::numeric_limits<float>::infinity();
  const ErrorMetrics metrics = compareImages(image, reference);
  EXPECT_EQ(metrics.nonFinite, 2);
  EXPECT_EQ(metrics.max, 1.0);
  EXPECT_NEAR(metrics.rms, std::sqrt(2.0 / 400.0), 1e-12);
  EXPECT_TRUE(std::isfinite(metrics.ssim));
  EXPECT_LT(metrics.ssim, 0.99);
  EXPECT_EQ(differenceImage(image, reference, 8.0f).pixels[30], 1.0f);
}

TEST(ErrorMetrics, SimilarityAgreesWithThePaperWrittenPlainly) {
  const FloatImage reference = makeImage({31, 23}, [](int x, int y) {
    return 0.5f + 0.4f * std::sin(0.5f * static_cast<float>(x) + 0.3f * static_cast<float>(y));
  });
  const FloatImage grain = noise(reference.size, 3);
  const FloatImage image = makeImage(reference.size, [&](int x, int y) {
    return 0.8f * reference.pixels[y * 31 + x] + 0.2f * grain.pixels[y * 31 + x];
  });
  EXPECT_NEAR(compareImages(image, reference).ssim, plainSimilarity(image, reference), 1e-9);
}

TEST(ErrorMetrics, WorksDownToOnePixel) {
  for (const glm::ivec2 size : {glm::ivec2{1, 1}, {1, 7}, {13, 1}, {10, 11}, {11, 10}, {3, 200}}) {
    const FloatImage image = noise(size, 4);
    EXPECT_NEAR(compareImages(image, image).ssim, 1.0, 1e-9) << size.x << 'x' << size.y;
    EXPECT_LT(compareImages(image, noise(size, 5)).ssim, 1.0) << size.x << 'x' << size.y;
  }
}

TEST(ErrorMetrics, ChannelsAreAveraged) {
  FloatImage reference{{12, 12}, 3, std::vector<float>(12 * 12 * 3, 0.5f)};
  FloatImage image = reference;
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) image.pixels[i] = 0.8f;
  const ErrorMetrics metrics = compareImages(image, reference);
  EXPECT_NEAR(metrics.rms, 0.3 / std::sqrt(3.0), 1e-7);
  EXPECT_NEAR(metrics.ssim, (2.0 + (0.8 + 1e-4) / (0.89 + 1e-4)) / 3.0, 1e-6);
}

TEST(ValueErrors, AreThoseOfTheWholePicture) {
  FloatImage image = noise({20, 20}, 1);
  image.pixels[7] = kNaN;
  const ErrorMetrics metrics = compareImages(image, noise({20, 20}, 2));
  const ValueErrors errors = compareValues(image, noise({20, 20}, 2));
  EXPECT_EQ(errors.rms, metrics.rms);
  EXPECT_EQ(errors.max, metrics.max);
  EXPECT_EQ(errors.nonFinite, 1);
  EXPECT_THROW(compareValues({}, {}), std::invalid_argument);
}

TEST(ErrorMetrics, RejectImagesOfDifferentShape) {
  EXPECT_THROW(compareImages(noise({4, 4}, 1), noise({4, 5}, 1)), std::invalid_argument);
  EXPECT_THROW(compareImages({}, {}), std::invalid_argument);
}

TEST(DifferenceImage, IsEnhancedAndClamped) {
  const FloatImage reference{{3, 1}, 1, {0.5f, 0.5f, 0.0f}};
  const FloatImage image{{3, 1}, 1, {0.5f, 0.45f, 1.0f}};
  const FloatImage difference = differenceImage(image, reference, 8.0f);
  EXPECT_EQ(difference.pixels[0], 0.0f);
  EXPECT_NEAR(difference.pixels[1], 0.4f, 1e-6f);
  EXPECT_EQ(difference.pixels[2], 1.0f);
}

}  // namespace
}  // namespace host
