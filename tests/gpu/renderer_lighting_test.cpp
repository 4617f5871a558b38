#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>

#include "host/renderer/embedded_shaders.h"
#include "tests/gpu/renderer_support.h"
#include "tests/support/glsl_function.h"

namespace host::test {
namespace {

constexpr double kPi = glm::pi<double>();

/// Half floats have eleven bits.
constexpr double kHalfTolerance = 2e-3;

class LightingTest : public RendererTest {};

/// What the highlights of a rough dielectric reflect of even light, seen along the normal: the fit of
/// brdf.glsl.
constexpr double kMirrored = 0.04 * (0.468 - 1.04 * 0.015) + 1.04 * 0.015 - 0.018;

/// What a chalk-white square reflects towards a viewer along its normal: with alpha = 1 the distribution of
/// microfacets is 1 / pi.
double chalkReflectance(double nDotL) {
  const double vDotH = std::sqrt((1.0 + nDotL) / 2.0);
  const double fresnel = 0.04 + 0.96 * std::pow(1.0 - vDotH, 5.0);
  const double visibility = 0.5 / (nDotL + 1.0);
  return (1.0 - kMirrored + fresnel * visibility) / kPi * nDotL;
}

Scene chalkSquare(const glm::mat4& transform = glm::mat4(1.0f)) {
  Scene scene = darkScene();
  place(scene, square(), chalk(), transform);
  return scene;
}

double centreRadiance(const FloatImage& image) {
  return centre(image).g;
}

Camera distantCamera() {
  Camera camera = frontCamera(100.0f);  // all view directions are nearly the same
  camera.verticalFov = 0.0005f;
  camera.farPlane = 200.0f;
  return camera;
}

TEST_F(LightingTest, SunOnAWhitePlaneGivesTheAnalyticRadiance) {
  for (const float degrees : {0.0f, 30.0f, 60.0f, 80.0f}) {
    const float angle = glm::radians(degrees);
    Scene scene = chalkSquare();
    scene.lights.push_back(sunAlong({std::sin(angle), 0.0f, -std::cos(angle)}, 2.0f));
    const double expected = 2.0 * chalkReflectance(std::cos(angle));
    EXPECT_NEAR(centreRadiance(drawLit(scene, distantCamera())) / expected, 1.0, 0.01) << degrees;
  }
}

TEST_F(LightingTest, SunFromBehindLightsNothing) {
  Scene scene = chalkSquare();
  scene.lights.push_back(sunAlong({0.3f, 0.2f, 1.0f}, 5.0f));
  EXPECT_EQ(centreRadiance(drawLit(scene, frontCamera())), 0.0);
}

TEST_F(LightingTest, PointLightsFallOffByTheSquareAndEndAtTheirRange) {
  Light lamp;
  lamp.type = LightType::point;
  lamp.intensity = 10.0f;
  const auto radianceAt = [&](float distance, float range) {
    Scene scene = chalkSquare();
    lamp.position = {0.0f, 0.0f, distance};
    lamp.range = range;
    scene.lights = {lamp};
    return centreRadiance(drawLit(scene, distantCamera()));
  };
  EXPECT_NEAR(radianceAt(2.0f, 0.0f), 10.0 / 4.0 * chalkReflectance(1.0), kHalfTolerance);
  EXPECT_NEAR(radianceAt(4.0f, 0.0f), 10.0 / 16.0 * chalkReflectance(1.0), kHalfTolerance);
  const double window = 1.0 - std::pow(0.5, 4.0);  // of KHR_lights_punctual, at half the range
  EXPECT_NEAR(radianceAt(2.0f, 4.0f), window * 10.0 / 4.0 * chalkReflectance(1.0), kHalfTolerance);
  EXPECT_EQ(radianceAt(2.0f, 1.9f), 0.0);
}

TEST_F(LightingTest, SpotLightsShineWithinTheirCone) {
  Light spot;
  spot.type = LightType::spot;
  spot.intensity = 8.0f;
  spot.position = {0.0f, 0.0f, 2.0f};
  spot.innerConeAngle = glm::radians(20.0f);
  spot.outerConeAngle = glm::radians(30.0f);
  const auto radianceOffAxis = [&](float degrees) {
    Scene scene = chalkSquare();
    const float angle = glm::radians(degrees);
    spot.direction = {std::sin(angle), 0.0f, -std::cos(angle)};
    scene.lights = {spot};
    return centreRadiance(drawLit(scene, distantCamera()));
  };
  const double full = 8.0 / 4.0 * chalkReflectance(1.0);
  EXPECT_NEAR(radianceOffAxis(0.0f), full, kHalfTolerance);
  EXPECT_NEAR(radianceOffAxis(18.0f), full, kHalfTolerance);
  const double between = (std::cos(glm::radians(25.0)) - std::cos(glm::radians(30.0))) /
                         (std::cos(glm::radians(20.0)) - std::cos(glm::radians(30.0)));
  EXPECT_NEAR(radianceOffAxis(25.0f), full * between * between, kHalfTolerance);
  EXPECT_EQ(radianceOffAxis(31.0f), 0.0);
}

TEST_F(LightingTest, LightsAddUp) {
  Scene scene = chalkSquare();
  scene.lights = {sunAlong({0.0f, 0.0f, -1.0f}, 1.0f), sunAlong({0.0f, 0.0f, -1.0f}, 0.5f)};
  Light lamp;
  lamp.type = LightType::point;
  lamp.position = {0.0f, 0.0f, 2.0f};
  scene.lights.resize(2 + 20, lamp);
  EXPECT_NEAR(centreRadiance(drawLit(scene, distantCamera())), (1.5 + 20.0 / 4.0) * chalkReflectance(1.0),
              5.0 * kHalfTolerance);
}

TEST_F(LightingTest, AmbientIsDimmedByOcclusionAndNothingElseIs) {
  Scene scene = chalkSquare();
  scene.ambient = glm::vec3(0.5f);
  scene.sky = {glm::vec3(1.0f), glm::vec3(1.0f), glm::vec3(1.0f), 1.0f};  // even: no tint
  const float quarter = 0.25f;
  const mres::gl::Texture2D occlusion(GL_R32F, glm::ivec2(1), "quarter", 1, &quarter);
  Renderer renderer(scene, profiler());
  renderer.drawGeometry(frontCamera(), kSize);
  const double open = centreRadiance(readTexture(renderer.drawLighting({}), kSize, 3));
  const double occluded =
      centreRadiance(readTexture(renderer.drawLighting({.accessibility = occlusion.id()}), kSize, 3));
  EXPECT_NEAR(open, 0.5, 0.02);  // a white surface in even light reflects it all
  EXPECT_NEAR(occluded, open * 0.25, kHalfTolerance);

  scene.ambient = glm::vec3(0.0f);
  scene.lights.push_back(sunAlong({0.0f, 0.0f, -1.0f}, 1.0f));
  scene.materials[0].emissive = glm::vec3(0.5f);
  Renderer sunny(scene, profiler());
  sunny.drawGeometry(frontCamera(), kSize);
  EXPECT_NEAR(centreRadiance(readTexture(sunny.drawLighting({.accessibility = occlusion.id()}), kSize, 3)),
              0.5 + chalkReflectance(1.0), 0.02);
}

TEST_F(LightingTest, TheSkyIsAGradientBehindEverything) {
  Scene scene = darkScene();
  scene.sky = {{0.1f, 0.2f, 0.9f}, {0.8f, 0.8f, 0.8f}, {0.3f, 0.2f, 0.1f}, 2.0f};
  const auto towards = [&](glm::vec3 direction) {
    return centre(drawLit(scene, lookAt("", {}, direction, 1.0f)));
  };
  EXPECT_NEAR(towards({0.0f, 1.0f, 0.0f}).b, 1.8f, 0.02f);
  EXPECT_NEAR(towards({0.0f, -1.0f, 0.0f}).r, 0.6f, 0.02f);
  EXPECT_NEAR(towards({1.0f, 0.001f, 0.0f}).r, 1.6f, 0.2f);
  Camera orthographic = lookAt("", {}, {0.0f, 1.0f, 0.0f}, 1.0f);
  orthographic.orthographicHeight = 10.0f;
  const FloatImage even = drawLit(scene, orthographic);
  EXPECT_EQ(pixel(even, {0, 0}), pixel(even, {63, 47}));
}

TEST_F(LightingTest, BlendedSurfacesCoverWhatIsBehindFromBackToFront) {
  Scene scene = darkScene();
  const auto addPane = [&](glm::vec3 glow, float alpha, float z, bool blended) {
    Material material;
    material.baseColor = {0.0f, 0.0f, 0.0f, alpha};
    material.emissive = glow;
    material.alphaMode = blended ? AlphaMode::blend : AlphaMode::opaque;
    place(scene, square(), material, glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, z)));
  };
  addPane({0.0f, 0.0f, 1.0f}, 0.25f, 1.0f, true);  // the nearest comes first in the scene
  addPane({1.0f, 0.0f, 0.0f}, 1.0f, -1.0f, false);
  addPane({0.0f, 1.0f, 0.0f}, 0.5f, 0.0f, true);
  addPane({9.0f, 9.0f, 9.0f}, 0.5f, -1.5f, true);  // hidden
  const glm::vec4 seen = centre(drawLit(scene, frontCamera()));
  EXPECT_NEAR(seen.r, 0.5f * 0.75f, kHalfTolerance);
  EXPECT_NEAR(seen.g, 0.5f * 0.75f, kHalfTolerance);
  EXPECT_NEAR(seen.b, 0.25f, kHalfTolerance);
}

/// sRGB code and the tone curve below its shoulder, for grey.
TEST_F(LightingTest, ToneMapIsPbrNeutralAndSrgb) {
  Scene scene = darkScene();
  Material material;
  material.baseColor = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  material.roughness = 1.0f;
  material.emissive = glm::vec3(0.3f);
  place(scene, square(), material);
  for (const auto& [stops, expected] : {std::pair(0.0f, 0.3f - 0.04f), std::pair(1.0f, 0.6f - 0.04f)}) {
    Renderer renderer(scene, profiler(), {.exposureCompensation = stops});
    renderer.drawGeometry(frontCamera(), kSize);
    renderer.drawLighting({});
    const float code = centre(readTexture(renderer.drawToneMap(), kSize, 3)).g;
    const FloatImage encoded = encodeSrgb({glm::ivec2(1), 1, {expected}});
    EXPECT_NEAR(code, encoded.pixels[0], 1.5f / 255.0f);
  }
}

TEST_F(LightingTest, ExtremeIntensitiesStayFinite) {
  Scene scene = chalkSquare();
  scene.materials[0].roughness = 0.0f;
  scene.lights.push_back(sunAlong({0.0f, 0.0f, -1.0f}, 1e30f));
  Light lamp;
  lamp.type = LightType::point;
  lamp.intensity = 1e30f;
  lamp.position = glm::vec3(0.0f);
  scene.lights.push_back(lamp);
  for (const float value : drawLit(scene, frontCamera()).pixels) ASSERT_TRUE(std::isfinite(value));
}

/// The part of evenly arriving light that the GLSL BRDF reflects, summed over the hemisphere at the viewer's
/// angle.
double reflectedPart(double nDotV, double roughness, double metallic) {
  std::vector<glm::vec4> directions;
  std::vector<glm::vec4> views;
  std::vector<double> weights;
  constexpr int kRings = 96;
  constexpr int kSectors = 96;
  for (int ring = 0; ring < kRings; ++ring) {
    const double cosine = (ring + 0.5) / kRings;
    const double sine = std::sqrt(1.0 - cosine * cosine);
    for (int sector = 0; sector < kSectors; ++sector) {
      const double around = (sector + 0.5) / kSectors * 2.0 * kPi;
      directions.emplace_back(sine * std::cos(around), sine * std::sin(around), cosine, roughness);
      views.emplace_back(std::sqrt(1.0 - nDotV * nDotV), 0.0, nDotV, metallic);
    }
  }
  const std::vector<glm::vec4> reflected = mres::test::evaluate(
      shaderLibrary().read("host/brdf.glsl"),
      "vec4(reflectedShare(reflectionOf(vec3(1.0), b.w, a.w, b.z), vec3(0.0, 0.0, 1.0), b.xyz, a.xyz), 1.0)",
      directions, views);
  double sum = 0.0;
  for (const glm::vec4& share : reflected) sum += share.g;
  return sum * 2.0 * kPi / (kRings * kSectors);
}

TEST_F(LightingTest, TheBrdfNeverReflectsMoreThanArrives) {
  for (const double roughness : {0.3, 0.6, 1.0}) {
    for (const double nDotV : {0.2, 0.6, 1.0}) {
      for (const double metallic : {0.0, 1.0}) {
        // The fit of what the highlights take is good to three per cent.
        const double part = reflectedPart(nDotV, roughness, metallic);
        EXPECT_LT(part, 1.03) << roughness << ' ' << nDotV << ' ' << metallic;
        EXPECT_GT(part, 0.3) << roughness << ' ' << nDotV << ' ' << metallic;
      }
    }
  }
}

}  // namespace
}  // namespace host::test
