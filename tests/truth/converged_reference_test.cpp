#include "host/truth/converged_reference.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "effects/ssao/ssao.h"
#include "host/renderer/read_texture.h"
#include "host/truth/grid_effect.h"
#include "tests/support/gl_test.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace host {
namespace {

using mres::test::SyntheticGBuffer;
using mres::test::TestEffect;

const WorkObserver kSilent = [](auto&&...) {};

SyntheticGBuffer roomOf(glm::ivec2 size) {
  const glm::mat4 projection = glm::perspective(1.0f, 1.6f, 0.1f, 50.0f);
  return {size, projection, mres::test::room()};
}

class Converged : public mres::test::GlTest {
 protected:
  Truth ofRecipe(const TestEffect::Recipe& recipe, const mres::Frame& frame) {
    return reference_.render({[&](int) { return std::make_unique<TestEffect>(recipe); }, 1, 1}, frame,
                             kSilent);
  }
  Truth ofSsao(int passes, const mres::Frame& frame) {
    const auto effect = [](int pass) {
      return std::make_unique<mres::Ssao>(mres::SsaoSettings{.samples = 4, .seed = pass});
    };
    return reference_.render({effect, passes, 4}, frame, kSilent);
  }

  ConvergedReference reference_{""};
};

constexpr float kHalfFloatStep = 0x1p-11f;  // of values up to 1

// Neighbours in the grid differ by a twentieth, and where the fraction begins anew by 1.
constexpr const char* kOfThePixel = "return vec4(fract(dot(surface.pixel, vec2(0.0137, 0.0071))));";

TEST_F(Converged, IsTheEffectAtThePixelsOfTheGrid) {
  for (const glm::ivec2 size :
       {glm::ivec2(160, 96), {1921, 33}, {163, 97}, {129, 66}, {28, 200}, {20, 20}, {1, 1}}) {
    const SyntheticGBuffer gbuffer = roomOf(size);
    const Truth truth = ofRecipe({.body = kOfThePixel}, gbuffer.frame());
    mres::MultiResolution full;
    full.settings().technique = mres::Technique::full;
    TestEffect effect({.body = kOfThePixel});
    const FloatImage picture = readTexture(full.render(effect, gbuffer.frame()), size, 1);
    const FloatImage expected = valuesAt(truth.grid, picture);
    ASSERT_EQ(truth.values.size, expected.size);
    ASSERT_FALSE(expected.pixels.empty());
    for (std::size_t i = 0; i < expected.pixels.size(); ++i)
      ASSERT_NEAR(truth.values.pixels[i], expected.pixels[i], kHalfFloatStep)
          << size.x << " x " << size.y << " at " << i;
  }
}

TEST_F(Converged, EvaluatesTheGridsPixelsAlone) {
  constexpr glm::ivec2 kSize(160, 96);
  const PixelGrid grid{kSize, 4, {5, 3}};
  GridEffect effect(std::make_unique<TestEffect>(TestEffect::Recipe{.body = "return vec4(1.0);"}), grid);
  mres::MultiResolution full;
  full.settings().technique = mres::Technique::full;
  const SyntheticGBuffer gbuffer = roomOf(kSize);
  const FloatImage picture = readTexture(full.render(effect, gbuffer.frame()), kSize, 1);
  EXPECT_THAT(valuesAt(grid, picture).pixels, testing::Each(1.0f));
  EXPECT_EQ(std::accumulate(picture.pixels.begin(), picture.pixels.end(), 0.0), 160 * 96 / 15);
}

TEST_F(Converged, IsTheMeanOfItsPasses) {
  const auto constantOfPass = [](int pass) {
    return std::make_unique<TestEffect>(
        TestEffect::Recipe{.body = "return vec4(" + std::to_string(pass) + ".0 / 4.0);",
                           .channels = 3,
                           .name = "pass" + std::to_string(pass)});
  };
  const Truth truth = reference_.render({constantOfPass, 4, 100}, roomOf({64, 64}).frame(), kSilent);
  EXPECT_EQ(truth.values.channels, 3);
  EXPECT_EQ(truth.count, 400);
  for (const float value : truth.values.pixels) EXPECT_EQ(value, 0.375f);
}

TEST_F(Converged, IsNotFiltered) {
  const TestEffect::Recipe noise{
      .body = "return vec4(float((surface.levelPixel.x + surface.levelPixel.y) & 1));", .filtered = true};
  const std::vector<float> values = ofRecipe(noise, roomOf({64, 64}).frame()).values.pixels;
  for (const float value : values) EXPECT_TRUE(value == 0.0f || value == 1.0f);
}

double distanceOf(const Truth& a, const Truth& b) {
  double squares = 0.0;
  for (std::size_t i = 0; i < a.values.pixels.size(); ++i)
    squares += std::pow(a.values.pixels[i] - b.values.pixels[i], 2.0);
  return std::sqrt(squares / static_cast<double>(a.values.pixels.size()));
}

TEST_F(Converged, ComesNearerWithMorePasses) {
  const SyntheticGBuffer gbuffer = roomOf({160, 96});
  const Truth best = ofSsao(128, gbuffer.frame());
  const double one = distanceOf(ofSsao(1, gbuffer.frame()), best);
  const double four = distanceOf(ofSsao(4, gbuffer.frame()), best);
  const double sixteen = distanceOf(ofSsao(16, gbuffer.frame()), best);
  EXPECT_LT(four, 0.7 * one);
  EXPECT_LT(sixteen, 0.7 * four);
}

TEST_F(Converged, ObserversCanStopItBetweenPasses) {
  const SyntheticGBuffer gbuffer = roomOf({64, 64});
  const auto effect = [](int) { return std::make_unique<mres::Ssao>(); };
  const auto stopHalfWay = [](double share, const std::string&) {
    if (share >= 0.5) throw std::runtime_error("stop");
  };
  EXPECT_THROW(reference_.render({effect, 4, 64}, gbuffer.frame(), stopHalfWay), std::runtime_error);
}

}  // namespace
}  // namespace host
