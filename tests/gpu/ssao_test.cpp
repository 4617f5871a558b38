// What ambient occlusion must mean, whatever its implementation.
#include "effects/ssao/ssao.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <random>

#include "tests/support/gl_test.h"
#include "tests/support/pictures.h"
#include "tests/support/sentences.h"
#include "tests/support/synthetic_gbuffer.h"

namespace mres::test {
namespace {

class SsaoTest : public GlTest {
 protected:
  Image render(const SyntheticGBuffer& gbuffer, const SsaoSettings& settings,
               Technique technique = Technique::full) {
    multiResolution_.settings().technique = technique;
    ssao_.setSettings(settings);
    return {gbuffer.frame().size, 1, renderPicture(multiResolution_, ssao_, gbuffer.frame())};
  }

  MultiResolution multiResolution_;
  Ssao ssao_;
};

double meanOf(const Image& image) {
  double sum = 0.0;
  for (const float value : image.texels) sum += static_cast<double>(value);
  return sum / static_cast<double>(image.texels.size());
}

/// World-space normals n * 0.5 + 0.5, seen by a camera that is turned at random.
NormalStorage unsignedNormals(GLenum format, unsigned seed = 1) {
  std::mt19937 generator(seed);
  std::normal_distribution<float> random;
  const glm::vec3 axis(random(generator), random(generator), random(generator));
  return {.format = format,
          .encoding = NormalEncoding::unsignedXyz,
          .space = NormalSpace::world,
          .view = glm::translate(glm::rotate(glm::mat4(1.0f), random(generator), glm::normalize(axis)),
                                 glm::vec3(3.0f, -2.0f, 1.0f))};
}

/// Where normals are perpendicular to the view the sample pattern's frame turns over: rounding must not
/// decide.
RayCaster leaningRoom() {
  const glm::dmat3 lean(glm::rotate(glm::dmat4(1.0), 0.3, glm::normalize(glm::dvec3(1.0, 1.0, 0.5))));
  return [lean, scene = room()](glm::dvec3 origin, glm::dvec3 direction) {
    std::optional<Hit> hit = scene(glm::transpose(lean) * origin, glm::transpose(lean) * direction);
    if (hit) hit->normal = lean * hit->normal;
    return hit;
  };
}

TEST_F(SsaoTest, EveryStorageOfNormalsShowsTheSamePicture) {
  const glm::ivec2 size(129, 97);
  const SsaoSettings settings{.samples = 32};
  for (const Technique technique : {Technique::full, Technique::multiResolution}) {
    const SyntheticGBuffer exact(size, perspective(size), leaningRoom());
    const Image expected = render(exact, settings, technique);
    for (const auto& [format, limit] :
         {std::pair(GL_RGBA32F, 1e-4), std::pair(GL_RGB10_A2, 0.003), std::pair(GL_RGBA8, 0.005)}) {
      for (unsigned seed = 1; seed < 4; ++seed) {
        const SyntheticGBuffer stored(size, perspective(size), leaningRoom(), {},
                                      unsignedNormals(static_cast<GLenum>(format), seed));
        const Image image = render(stored, settings, technique);
        EXPECT_LT(rootMeanSquare(image.texels, expected.texels), limit) << format << ", seed " << seed;
      }
    }
  }
}

TEST_F(SsaoTest, PlanesDoNotOccludeThemselves) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> random(0.0, 1.0);
  const glm::ivec2 size(129, 97);
  const std::vector<glm::mat4> projections = {perspective(size), perspective(size, 25.0f),
                                              glm::ortho(-4.0f, 4.0f, -3.0f, 3.0f, 0.1f, 100.0f)};
  // Eight bits turn a normal by 0.0068 at most: at twice the radius that rises by less than the default bias.
  const std::vector<std::pair<DepthStorage, NormalStorage>> storages = {
      {{}, {}},
      {{.format = GL_DEPTH_COMPONENT24}, unsignedNormals(GL_RGB10_A2)},
      {{.format = GL_DEPTH_COMPONENT24}, unsignedNormals(GL_RGBA8)}};
  for (int i = 0; i < 36; ++i) {
    const double tilt = glm::radians(i % 3 == 0 ? 89.0 : 85.0 * random(generator));
    const double azimuth = 6.3 * random(generator);
    const glm::dvec3 normal(std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth),
                            std::cos(tilt));
    const double distance = std::exp(4.0 * random(generator) - 0.7);
    const auto& projection = projections.at(static_cast<std::size_t>(i) % projections.size());
    const auto& [depths, normals] = storages.at(static_cast<std::size_t>(i) / 12);
    const SyntheticGBuffer gbuffer(size, projection, plane(normal, -normal.z * distance), depths, normals);
    for (const float radius : {0.1f, 0.5f, 4.0f}) {
      for (const Technique technique : {Technique::full, Technique::multiResolution}) {
        ASSERT_THAT(render(gbuffer, {.radius = radius, .samples = 16}, technique).texels, testing::Each(1.0f))
            << (technique == Technique::full ? "full" : "mixed") << ", case " << i << ", tilt "
            << glm::degrees(tilt) << ", distance " << distance << ", radius " << radius;
      }
    }
  }
}

TEST_F(SsaoTest, DarkensTowardsAContactAndNoFurtherThanItsReach) {
  const glm::ivec2 size(240, 180);
  const glm::mat4 projection = perspective(size);
  const SyntheticGBuffer gbuffer(size, projection,
                                 nearest({plane({0.0, 1.0, 0.0}, -1.0), plane({0.0, 0.0, 1.0}, -5.0)}));
  for (const Technique technique : {Technique::full, Technique::multiResolution}) {
    const Image image = render(gbuffer, {.radius = 1.0f, .samples = 64}, technique);
    double before = 0.0;
    for (const double distance : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      const double accessibility = meanAround(image, pixelOf(projection, size, {0.0, -1.0, -5.0 + distance}));
      EXPECT_GT(accessibility, before + 0.01) << distance << " m from the wall";
      before = accessibility;
    }
    EXPECT_LT(meanAround(image, pixelOf(projection, size, {0.0, -1.0, -4.9})), 0.8);
    EXPECT_GT(meanAround(image, pixelOf(projection, size, {0.0, -1.0, -3.0})), 0.99);
  }
}

TEST_F(SsaoTest, CornersAreDarkerThanEdgesAndEdgesThanWalls) {
  const glm::ivec2 size(240, 180);
  const glm::mat4 projection = perspective(size);
  const SyntheticGBuffer gbuffer(size, projection, box({-2.0, -1.5, -5.0}, {2.0, 1.5, 1.0}));
  const Image image = render(gbuffer, {.radius = 0.8f, .samples = 64});
  const double corner = meanAround(image, pixelOf(projection, size, {-1.85, -1.35, -5.0}));
  const double edge = meanAround(image, pixelOf(projection, size, {-1.85, 0.0, -5.0}));
  const double wall = meanAround(image, pixelOf(projection, size, {0.0, 0.0, -5.0}));
  EXPECT_LT(corner, edge - 0.05);
  EXPECT_LT(edge, wall - 0.1);
  EXPECT_GT(wall, 0.99);
}

TEST_F(SsaoTest, WithoutReachOrIntensityIsNothing) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  for (const Technique technique : {Technique::full, Technique::multiResolution}) {
    EXPECT_THAT(render(gbuffer, {.radius = 0.0f, .samples = 8}, technique).texels, testing::Each(1.0f));
    EXPECT_THAT(render(gbuffer, {.samples = 8, .intensity = 0.0f}, technique).texels, testing::Each(1.0f));
  }
}

TEST_F(SsaoTest, EveryNumberOfSamplesIsInRangeAndAgrees) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const Image many = render(gbuffer, {.samples = 256});
  for (const int samples : {1, 2, 3, 16, 256}) {
    for (const float radius : {1e-4f, 0.5f, 100.0f}) {
      const Image image = render(gbuffer, {.radius = radius, .samples = samples, .intensity = 2.0f});
      for (const float value : image.texels) ASSERT_TRUE(value >= 0.0f && value <= 1.0f) << value;
    }
    EXPECT_NEAR(meanOf(render(gbuffer, {.samples = samples})), meanOf(many), samples < 16 ? 0.05 : 0.01)
        << samples;
  }
}

TEST_F(SsaoTest, DoesNotDependOnTheResolution) {
  const glm::ivec2 small(160, 120);
  const glm::ivec2 large(320, 240);
  const SsaoSettings settings{.samples = 64};
  const Image coarse = render(SyntheticGBuffer(small, perspective(small), room()), settings);
  const Image fine = render(SyntheticGBuffer(large, perspective(large), room()), settings);
  double sum = 0.0;
  int far = 0;
  for (int y = 0; y < small.y; ++y) {
    for (int x = 0; x < small.x; ++x) {
      float mean = 0.0f;
      for (int i = 0; i < 4; ++i) mean += 0.25f * fine.at({2 * x + i % 2, 2 * y + i / 2});
      const double difference = std::abs(static_cast<double>(mean - coarse.at({x, y})));
      sum += difference;
      far += difference > 0.1 ? 1 : 0;
    }
  }
  EXPECT_LT(sum / (small.x * small.y), 0.01);
  EXPECT_LT(far, small.x * small.y / 50) << "only at contours";
}

TEST_F(SsaoTest, DoesNotDependOnTheUnitOfLength) {
  const glm::ivec2 size(129, 97);
  const float aspect = 129.0f / 97.0f;
  const auto scaled = [](double scale) -> RayCaster {
    return [scale, scene = room()](glm::dvec3 origin, glm::dvec3 direction) {
      std::optional<Hit> hit = scene(origin / scale, direction);
      if (hit) hit->viewDepth *= scale;
      return hit;
    };
  };
  for (const Technique technique : {Technique::full, Technique::multiResolution}) {
    multiResolution_.settings().mask.depthThreshold = 0.05f;
    const SyntheticGBuffer metres(size, glm::perspective(1.0f, aspect, 0.1f, 100.0f), room());
    const Image expected = render(metres, {.radius = 0.09f, .samples = 32}, technique);
    for (const float scale : {1e-3f, 1e3f}) {
      multiResolution_.settings().mask.depthThreshold = 0.05f * scale;
      const SyntheticGBuffer gbuffer(size, glm::perspective(1.0f, aspect, 0.1f * scale, 100.0f * scale),
                                     scaled(static_cast<double>(scale)));
      const Image image = render(gbuffer, {.radius = 0.09f * scale, .samples = 32}, technique);
      EXPECT_LT(rootMeanSquare(image.texels, expected.texels), 0.003) << scale;
    }
  }
}

TEST_F(SsaoTest, BackgroundIsOpen) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size),
                                 nearest({sphere({0.0, 0.0, -3.0}, 1.0), sphere({0.8, 0.3, -2.0}, 0.3)}));
  const Image image = render(gbuffer, {.radius = 2.0f, .samples = 16, .intensity = 4.0f});
  for (std::size_t i = 0; i < image.texels.size(); ++i) {
    ASSERT_TRUE(gbuffer.depths()[i] < 1.0f || image.texels[i] == 1.0f) << image.texels[i];
  }
  const SyntheticGBuffer farBefore(size, perspective(size), sphere({0.0, 0.0, -104.0}, 5.0));
  EXPECT_GT(meanOf(render(farBefore, {.radius = 4.0f, .samples = 16})), 0.999) << "the sky occludes nothing";
  const SyntheticGBuffer sky(size, perspective(size), nearest({}));
  EXPECT_THAT(render(sky, {.samples = 4}, Technique::multiResolution).texels, testing::Each(1.0f));
}

TEST_F(SsaoTest, ReversedAndInfiniteDepthShowTheSamePicture) {
  const glm::ivec2 size(129, 97);
  glm::mat4 reversed(0.0f);
  const glm::mat4 usual = perspective(size);
  reversed[0][0] = usual[0][0];
  reversed[1][1] = usual[1][1];
  reversed[2][3] = -1.0f;
  reversed[3][2] = 0.1f;
  const Image expected = render(SyntheticGBuffer(size, usual, room()), {.samples = 32});
  const DepthStorage storage{GL_DEPTH_COMPONENT32F, ClipDepth::zeroToOne, true};
  EXPECT_LT(rootMeanSquare(render(SyntheticGBuffer(size, reversed, room(), storage), {.samples = 32}).texels,
                           expected.texels),
            0.003);
  for (const GLenum format : {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT16}) {
    EXPECT_LT(rootMeanSquare(
                  render(SyntheticGBuffer(size, usual, room(), {.format = format}), {.samples = 32}).texels,
                  expected.texels),
              0.01);
  }
}

TEST_F(SsaoTest, SettingsOutOfRangeAreRefused) {
  for (const SsaoSettings& bad :
       {SsaoSettings{.radius = -1.0f}, SsaoSettings{.radius = NAN}, SsaoSettings{.samples = 0},
        SsaoSettings{.samples = 257}, SsaoSettings{.intensity = -0.1f}, SsaoSettings{.bias = 2.0f}}) {
    EXPECT_THAT([&] { ssao_.setSettings(bad); }, refusesInASentence("SsaoSettings::"));
  }
  SsaoSettings bad;
  bad.levels[2].maskVariance = NAN;
  EXPECT_THAT([&] { ssao_.setSettings(bad); }, refusesInASentence("maskVariance must be 0 to 64 pixels^2."));
  EXPECT_EQ(ssao_.settings().radius, SsaoSettings{}.radius);
}

}  // namespace
}  // namespace mres::test
