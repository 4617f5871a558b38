// The filter of each level: exact means of repeating patterns on surfaces, nothing taken across steps.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/gl_test.h"
#include "tests/support/mask_bench.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

constexpr const char* kPattern =
    "int i = surface.noisePixel.y * 4 + surface.noisePixel.x;\n"
    "return vec4(float(i * 7 % 16) / 16.0);";
/// The mean of as much of it as repeats.
double patternMean(int period) {
  double sum = 0.0;
  for (int y = 0; y < period; ++y) {
    for (int x = 0; x < period; ++x) sum += (y * 4 + x) * 7 % 16 / 16.0;
  }
  return sum / (period * period);
}
constexpr double kHalfRounding = 1.0 / 2048.0;

glm::dvec3 tilted(double degrees, double azimuth) {
  const double tilt = glm::radians(degrees);
  return {std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt)};
}

double largestDistance(const Image& image, double expected) {
  double worst = 0.0;
  for (const float value : image.texels)
    worst = std::max(worst, std::abs(static_cast<double>(value) - expected));
  return worst;
}

class Filter : public GlTest {
 protected:
  Image render(TestEffect& effect, const Frame& frame, Technique technique = Technique::full) {
    multiResolution_.settings().technique = technique;
    return {frame.size, effect.description().channels, renderPicture(multiResolution_, effect, frame)};
  }

  MultiResolution multiResolution_;
};

TEST_F(Filter, CoarseLevelsShowARampWhereItIs) {
  for (const glm::ivec2 size : {glm::ivec2(256, 192), glm::ivec2(251, 183)}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), plane({0.0, 0.0, 1.0}, -10.0));
    TestEffect effect({.body = "return vec4(dot(surface.pixel, vec2(0.0015, 0.002)));", .filtered = true});
    const Image full = render(effect, gbuffer.frame());
    const Image coarse = render(effect, gbuffer.frame(), Technique::multiResolution);
    constexpr int kBorder = 24;  // where the filter lacks neighbours
    for (int y = kBorder; y < size.y - kBorder; ++y)
      for (int x = kBorder; x < size.x - kBorder; ++x)
        ASSERT_NEAR(coarse.at({x, y}), full.at({x, y}), 0.0015) << x << ", " << y;
  }
}

TEST_F(Filter, IntegratesAPatternExactlyOnPlanesOfEveryTilt) {
  const glm::ivec2 size(61, 47);
  TestEffect one({.body = kPattern, .filtered = true, .name = "one"});
  TestEffect three({.body = kPattern, .channels = 3, .filtered = true, .name = "three"});
  const glm::mat4 orthographic = glm::ortho(-1.5f, 1.5f, -1.0f, 1.0f, 0.1f, 30.0f);
  for (const glm::mat4& projection : {perspective(size, 10.0f), orthographic}) {
    for (const double tilt : {0.0, 30.0, 60.0, 75.0}) {
      const glm::dvec3 normal = tilted(tilt, 0.6);
      const SyntheticGBuffer gbuffer(size, projection, plane(normal, -normal.z * 10.0));
      EXPECT_LT(largestDistance(render(one, gbuffer.frame()), patternMean(4)), kHalfRounding) << tilt;
      EXPECT_LT(largestDistance(render(three, gbuffer.frame()), patternMean(4)), kHalfRounding) << tilt;
    }
  }
}

TEST_F(Filter, WorksOnBothSidesOfTheEyeOfAnOrthographicCamera) {
  const glm::ivec2 size(61, 47);
  TestEffect effect({.body = kPattern, .filtered = true});
  const glm::mat4 projection = glm::ortho(-1.5f, 1.5f, -1.0f, 1.0f, -20.0f, 30.0f);
  for (const double depth : {-15.0, -0.5, 0.0, 20.0}) {
    const auto tiltedPlane = [depth](glm::dvec3 origin, glm::dvec3) {
      return Hit{depth + 0.3 * origin.x + 0.2 * origin.y, glm::normalize(glm::dvec3(0.3, 0.2, 1.0))};
    };
    const SyntheticGBuffer gbuffer(size, projection, tiltedPlane);
    EXPECT_LT(largestDistance(render(effect, gbuffer.frame()), patternMean(4)), kHalfRounding) << depth;
  }
}

TEST_F(Filter, IntegratesThePatternOfACoarseLevel) {
  const glm::ivec2 size(257, 193);
  const SyntheticGBuffer gbuffer(size, perspective(size), plane({0.2, 0.1, 1.0}, -5.0));
  for (const int period : {1, 2, 3, 4}) {
    LevelTable levels = kSsaoLevels;
    levels[3].noisePeriod = period;
    TestEffect effect({.body = kPattern, .filtered = true, .levels = levels});
    const Image image = render(effect, gbuffer.frame(), Technique::multiResolution);
    EXPECT_LT(largestDistance(image, patternMean(period)), kHalfRounding) << period;
  }
}

TEST_F(Filter, TakesNothingAcrossADepthStep) {
  const glm::ivec2 size(63, 41);
  TestEffect effect(
      {.body = "return vec4(surface.depth < 2.5 ? 0.25 : 0.75);", .channels = 3, .filtered = true});
  for (const double back : {2.6, 3.0, 40.0}) {
    const auto scene = [back](glm::dvec3 origin, glm::dvec3 direction) {
      const bool front = std::fmod(std::abs(7.0 * direction.x + 3.0 * direction.y), 2.0) < 1.0;
      return plane({0.0, 0.0, 1.0}, front ? -2.0 : -back)(origin, direction);
    };
    const Image image = render(effect, SyntheticGBuffer(size, perspective(size), scene).frame());
    for (const float value : image.texels) ASSERT_TRUE(value == 0.25f || value == 0.75f) << value;
  }
}

TEST_F(Filter, TakesNothingFromTheSkyNorGivesItAnything) {
  const glm::ivec2 size(63, 41);
  TestEffect effect({.body = "return vec4(0.25);", .filtered = true, .background = glm::vec4(1.0f)});
  for (const double depth : {0.2, 5.0, 90.0}) {
    const SyntheticGBuffer gbuffer(size, perspective(size), sphere({0.0, 0.0, -depth}, 0.3 * depth));
    const Image image = render(effect, gbuffer.frame());
    for (std::size_t i = 0; i < image.texels.size(); ++i) {
      ASSERT_EQ(image.texels[i], gbuffer.depths()[i] == 1.0f ? 1.0f : 0.25f);
    }
  }
}

TEST_F(Filter, SurfacesWithoutANormalKeepTheirValue) {
  const glm::ivec2 size(24, 24);
  TestEffect effect({.body = "return vec4(0.25 + 0.5 * float(surface.levelPixel.x & 1));", .filtered = true});
  const auto scene = [](glm::dvec3, glm::dvec3) { return Hit{3.0, glm::dvec3(0.0)}; };
  const Image image = render(effect, SyntheticGBuffer(size, perspective(size), scene).frame());
  for (int x = 0; x < size.x; ++x) EXPECT_EQ(image.at({x, 5}), x % 2 == 0 ? 0.25f : 0.75f);
}

}  // namespace
}  // namespace mres::test
