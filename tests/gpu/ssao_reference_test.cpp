// SSAO's shade() on the GPU against an independent double-precision implementation.
#include "tests/support/ssao_reference.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/gl_test.h"
#include "tests/support/pictures.h"
#include "tests/support/unfiltered.h"

namespace mres::test {
namespace {

class SsaoReferenceTest : public GlTest {
 protected:
  /// Compares some hundreds of pixels. A few samples of a pixel may fall to the other side of a decision
  /// (which pixel, which mip, in front or behind) by rounding: at most three, and in few pixels.
  void expectLikeReference(const SyntheticGBuffer& gbuffer, const SsaoSettings& settings) {
    Unfiltered<Ssao> effect(settings);
    MultiResolution multiResolution;
    multiResolution.settings().technique = Technique::full;
    const Picture picture = renderPicture(multiResolution, effect, gbuffer.frame());
    const SsaoReference reference(gbuffer, settings);
    const glm::ivec2 size = gbuffer.frame().size;
    const double sample = static_cast<double>(settings.intensity) / settings.samples;
    constexpr double kHalfRounding = 1.0 / 2048.0;
    int compared = 0;
    int flipped = 0;
    double sum = 0.0;
    for (int i = 5; i < size.x * size.y; i += 29) {
      const glm::ivec2 pixel(i % size.x, i / size.x);
      const double difference = std::abs(reference.accessibility(pixel) -
                                         static_cast<double>(picture[static_cast<std::size_t>(i)]));
      ASSERT_LE(difference, 3.01 * sample + kHalfRounding) << pixel.x << ", " << pixel.y;
      ++compared;
      flipped += difference > kHalfRounding ? 1 : 0;
      sum += difference;
    }
    EXPECT_GT(compared, 300);
    EXPECT_LT(flipped, compared / 10);
    EXPECT_LT(sum / compared, 0.05 * sample + 0.5 * kHalfRounding);
  }
};

TEST_F(SsaoReferenceTest, OfARoom) {
  const glm::ivec2 size(131, 97);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  expectLikeReference(gbuffer, {.radius = 0.5f, .samples = 16});
  expectLikeReference(gbuffer, {.radius = 0.5f, .samples = 64, .seed = 7});
  expectLikeReference(gbuffer, {.radius = 3.0f, .samples = 32, .intensity = 1.5f, .bias = 0.05f});
}

TEST_F(SsaoReferenceTest, OfASphereOnAPlane) {
  const glm::ivec2 size(160, 120);
  const SyntheticGBuffer gbuffer(size, perspective(size, 40.0f),
                                 nearest({plane({0.0, 1.0, 0.1}, -1.0), sphere({0.2, -0.4, -4.0}, 0.7)}));
  expectLikeReference(gbuffer, {.radius = 1.0f, .samples = 32});
  expectLikeReference(gbuffer, {.radius = 0.2f, .samples = 8});
}

TEST_F(SsaoReferenceTest, OfOrthographicAndOffCentreViews) {
  const glm::ivec2 size(131, 97);
  const SyntheticGBuffer orthographic(size, glm::ortho(-3.0f, 3.0f, -1.4f, 2.0f, 0.1f, 20.0f), room());
  expectLikeReference(orthographic, {.radius = 0.6f, .samples = 24});
  const SyntheticGBuffer offCentre(size, glm::frustum(-0.12f, 0.02f, -0.03f, 0.08f, 0.1f, 30.0f), room());
  expectLikeReference(offCentre, {.radius = 0.6f, .samples = 24});
}

}  // namespace
}  // namespace mres::test
