#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>

#include "host/measure/effect_instance.h"
#include "host/renderer/shadow/shadow_fit.h"
#include "tests/gpu/renderer_support.h"

namespace host::test {
namespace {

class ShadowTest : public RendererTest {};

/// A floor of 20 metres whose normal is +Y.
void addFloor(Scene& scene, const glm::mat4& tilt = glm::mat4(1.0f)) {
  const glm::mat4 flat = glm::rotate(glm::mat4(1.0f), -glm::half_pi<float>(), glm::vec3(1.0f, 0.0f, 0.0f));
  place(scene, square(), chalk(), tilt * flat * glm::scale(glm::mat4(1.0f), glm::vec3(10.0f)));
}

Camera fromAbove(glm::vec3 target = glm::vec3(0.0f)) {
  Camera camera = lookAt("above", target + glm::vec3(0.0f, 12.0f, 0.01f), target, 40.0f);
  camera.farPlane = 50.0f;
  return camera;
}

/// The pixel, from the upper left, that shows a point of the floor.
glm::ivec2 pixelOfFloor(const Renderer& renderer, glm::ivec2 size, float x, float z) {
  const glm::vec4 clip = renderer.projection() * renderer.view() * glm::vec4(x, 0.0f, z, 1.0f);
  const glm::vec2 fromUpperLeft = glm::vec2(clip.x, -clip.y) / clip.w * 0.5f + 0.5f;
  return {fromUpperLeft * glm::vec2(size)};
}

/// Lit over unlit: 1 where the sun is seen.
FloatImage visibility(const FloatImage& lit) {
  FloatImage result = lit;
  const float brightest = *std::ranges::max_element(lit.pixels);
  for (float& value : result.pixels) value /= brightest;
  return result;
}

TEST_F(ShadowTest, ABoxCastsItsShadowWhereGeometrySays) {
  Scene scene = darkScene();
  addFloor(scene);
  // A cube of 1 m whose lower side is 1 m above the floor; a sun at 45 degrees moves its shadow by 1 to 2 m
  // in x.
  place(scene, cube(), chalk(),
        glm::scale(glm::translate(glm::mat4(1.0f), {0.0f, 1.5f, 0.0f}), glm::vec3(0.5f)));
  scene.lights.push_back(sunAlong({1.0f, -1.0f, 0.0f}, 1.0f));
  const FloatImage seen = visibility(drawLit(scene, fromAbove(), {96, 96}));
  const float metresPerPixel = 2.0f * 12.0f * std::tan(glm::radians(20.0f)) / 96.0f;
  const auto at = [&](float x, float z) {
    return pixel(seen, glm::ivec2(glm::vec2(x, z) / metresPerPixel + 48.0f)).g;
  };
  EXPECT_LT(at(1.5f, 0.0f), 0.01f);
  EXPECT_LT(at(2.3f, 0.3f), 0.01f);
  EXPECT_GT(at(2.75f, 0.0f), 0.9f);
  EXPECT_GT(at(1.5f, 0.75f), 0.9f);
  EXPECT_GT(at(-2.0f, 0.0f), 0.9f);
}

TEST_F(ShadowTest, AContactShadowStartsAtTheContact) {
  Scene scene = darkScene();
  addFloor(scene);
  place(scene, cube(), chalk(), glm::translate(glm::mat4(1.0f), {-1.0f, 1.0f, 0.0f}));  // its side is x = 0
  scene.lights.push_back(sunAlong({1.0f, -1.0f, 0.0f}, 1.0f));
  Camera camera = lookAt("contact", {0.6f, 0.5f, 0.0f}, {0.0f, 0.0f, 0.0f}, 20.0f);
  camera.nearPlane = 0.01f;
  camera.farPlane = 20.0f;
  const FloatImage lit = drawLit(scene, camera, {64, 64});
  // Just under the middle lies the floor, less than two centimetres in front of the box.
  EXPECT_LT(pixel(lit, {32, 33}).g, 0.01f);
  EXPECT_LT(pixel(lit, {32, 36}).g, 0.01f);
}

TEST_F(ShadowTest, NoSurfaceShadowsItself) {
  for (const float sunDegrees : {5.0f, 20.0f, 45.0f, 70.0f, 89.0f}) {
    for (const float tiltDegrees : {0.0f, 10.0f, 40.0f}) {
      Scene scene = darkScene();
      const float sun = glm::radians(sunDegrees);
      const glm::vec3 axis = glm::normalize(glm::vec3(0.3f, 0.0f, 1.0f));
      addFloor(scene, glm::rotate(glm::mat4(1.0f), glm::radians(tiltDegrees), axis));
      scene.lights.push_back(sunAlong({std::cos(sun), -std::sin(sun), 0.2f * std::cos(sun)}, 1.0f));
      const FloatImage lit = drawLit(scene, fromAbove(), {96, 96});
      const auto [least, most] = std::ranges::minmax_element(lit.pixels);
      ASSERT_GT(*most, 0.0f);
      EXPECT_GT(*least, 0.9f * *most) << sunDegrees << " degrees of sun, tilt " << tiltDegrees;
    }
  }
}

TEST_F(ShadowTest, CurvedSurfacesShadowThemselvesOnlyBeyondTheTerminator) {
  Scene scene = darkScene();
  Mesh ball;
  for (int ring = 0; ring <= 64; ++ring) {
    for (int sector = 0; sector <= 128; ++sector) {
      const float polar = static_cast<float>(ring) / 64.0f * glm::pi<float>();
      const float around = static_cast<float>(sector) / 128.0f * glm::two_pi<float>();
      const glm::vec3 normal(std::sin(polar) * std::sin(around), std::cos(polar),
                             std::sin(polar) * std::cos(around));
      ball.vertices.push_back({normal, normal, {1.0f, 0.0f, 0.0f, 1.0f}, {}});
    }
  }
  for (std::uint32_t ring = 0; ring < 64; ++ring) {
    for (std::uint32_t sector = 0; sector < 128; ++sector) {
      const std::uint32_t a = ring * 129 + sector;
      for (const std::uint32_t index : {a, a + 129, a + 1, a + 1, a + 129, a + 130})
        ball.indices.push_back(index);
    }
  }
  place(scene, ball, chalk());
  scene.lights.push_back(sunAlong({-1.0f, 0.0f, 0.0f}, 1.0f));
  const Camera camera = frontCamera(4.0f);
  const GBuffer gbuffer = drawGBuffer(scene, camera, {96, 96});
  const FloatImage lit = drawLit(scene, camera, {96, 96});
  int checked = 0;
  for (int y = 0; y < 96; ++y) {
    for (int x = 0; x < 96; ++x) {
      if (pixel(gbuffer.depth, {x, y}).x == 1.0f) continue;
      const float cosine = unpackNormal(pixel(gbuffer.normal, {x, y})).x;
      if (cosine < 0.15f) continue;
      ++checked;
      EXPECT_GT(pixel(lit, {x, y}).g, 0.85f * cosine * 0.9f / glm::pi<float>()) << x << ", " << y;
    }
  }
  EXPECT_GT(checked, 500);
}

TEST_F(ShadowTest, AlphaMaskedCastersLeaveHolesAndGlassCastsNothing) {
  const auto lightUnder = [&](AlphaMode mode, std::uint8_t alpha) {
    Scene scene = darkScene();
    addFloor(scene);
    Material screen = chalk();
    screen.alphaMode = mode;
    screen.doubleSided = true;
    screen.baseColorTexture.texture = addTexture(scene, {1, 1}, {255, 255, 255, alpha});
    const glm::mat4 flat = glm::rotate(glm::mat4(1.0f), glm::half_pi<float>(), glm::vec3(1.0f, 0.0f, 0.0f));
    place(scene, square(), screen, glm::translate(glm::mat4(1.0f), {2.0f, 2.0f, 0.0f}) * flat);
    scene.lights.push_back(sunAlong({-1.0f, -1.0f, 0.0f}, 1.0f));
    return centre(drawLit(scene, fromAbove())).g;
  };
  EXPECT_EQ(lightUnder(AlphaMode::opaque, 0), 0.0f);
  EXPECT_EQ(lightUnder(AlphaMode::mask, 200), 0.0f);
  EXPECT_GT(lightUnder(AlphaMode::mask, 50), 0.1f);
  EXPECT_GT(lightUnder(AlphaMode::blend, 200), 0.1f);
}

TEST_F(ShadowTest, TheMapIsKeptWhileNothingChanges) {
  Scene scene = darkScene();
  addFloor(scene);
  scene.lights.push_back(sunAlong({1.0f, -1.0f, 0.0f}, 1.0f));
  mres::gl::Profiler timed(mres::gl::Profiler::Mode::finish);
  Renderer renderer(scene, timed);
  const auto drewShadow = [&](const Camera& camera) {
    timed.beginFrame();
    renderer.drawGeometry(camera, kSize);
    timed.endFrame();
    return std::ranges::any_of(timed.stages(), [](const auto& stage) { return stage.name == "host.shadow"; });
  };
  EXPECT_TRUE(drewShadow(fromAbove()));
  EXPECT_FALSE(drewShadow(fromAbove()));
  EXPECT_FALSE(drewShadow(fromAbove({0.001f, 0.0f, 0.001f}))) << "less than a texel";
  EXPECT_TRUE(drewShadow(fromAbove({5.0f, 0.0f, 0.0f})));
}

TEST_F(ShadowTest, ASpotLightCastsShadowsIfThereIsNoSun) {
  Scene scene = darkScene();
  addFloor(scene);
  // From 4 m over the floor; the cube's upper side, at 2 m, reaches 0.5 m to each side: its shadow 1 m.
  place(scene, cube(), chalk(),
        glm::scale(glm::translate(glm::mat4(1.0f), {0.0f, 1.5f, 0.0f}), glm::vec3(0.5f)));
  Light spot;
  spot.type = LightType::spot;
  spot.intensity = 100.0f;
  spot.position = {0.0f, 4.0f, 0.0f};
  spot.outerConeAngle = glm::radians(40.0f);
  spot.innerConeAngle = glm::radians(39.0f);
  scene.lights.push_back(spot);
  Camera camera = lookAt("low", {0.0f, 0.4f, 4.0f}, {0.0f, 0.0f, 0.0f}, 50.0f);
  camera.farPlane = 50.0f;
  mres::gl::Profiler off;
  Renderer renderer(scene, off);
  const glm::ivec2 size(192, 144);
  renderer.drawGeometry(camera, size);
  const FloatImage lit = readTexture(renderer.drawLighting({}), size, 3);
  const auto at = [&](float x, float z) { return pixel(lit, pixelOfFloor(renderer, size, x, z)).g; };
  EXPECT_EQ(at(0.0f, 0.8f), 0.0f);
  EXPECT_EQ(at(0.85f, 0.0f), 0.0f);
  EXPECT_GT(at(1.2f, 0.5f), 0.1f);
  EXPECT_GT(at(0.0f, 1.2f), 0.1f);
  EXPECT_EQ(at(0.0f, -4.0f), 0.0f) << "outside of the cone";
  EXPECT_NE(renderer.shadowMap().map, 0U);
  EXPECT_EQ(renderer.shadowMap().light.w, 1.0f);
}

TEST_F(ShadowTest, MapsOfEverySizeShowTheSameShadow) {
  Scene scene = darkScene();
  addFloor(scene);
  place(scene, cube(), chalk(), glm::translate(glm::mat4(1.0f), {0.0f, 1.0f, 0.0f}));
  scene.lights.push_back(sunAlong({1.0f, -1.0f, 0.0f}, 1.0f));
  mres::gl::Profiler off;
  for (const int size : {kLeastShadowMapSize, 512, 8192}) {
    Renderer renderer(scene, off, {.shadowMapSize = size});
    renderer.drawGeometry(fromAbove(), kSize);
    const FloatImage seen = visibility(readTexture(renderer.drawLighting({}), kSize, 3));
    const float metresPerPixel = 2.0f * 12.0f * std::tan(glm::radians(20.0f)) / static_cast<float>(kSize.y);
    const auto at = [&](float x) {
      return pixel(seen, glm::ivec2(glm::vec2(x, 0.0f) / metresPerPixel + glm::vec2(kSize) * 0.5f)).g;
    };
    EXPECT_LT(at(1.7f), 0.05f) << size;
    EXPECT_GT(at(-2.0f), 0.95f) << size;
    EXPECT_GT(at(3.7f), 0.95f) << size;
  }
}

/// A wall of 20 cm, two metres high, with the sun behind it: from x = 1 on, its shadow is two metres long.
Scene wallInTheSun() {
  Scene scene = darkScene();
  addFloor(scene);
  place(scene, cube(), chalk(),
        glm::scale(glm::translate(glm::mat4(1.0f), {0.9f, 1.0f, 0.0f}), glm::vec3(0.1f, 1.0f, 1.0f)));
  scene.lights.push_back(sunAlong({1.0f, -1.0f, 0.0f}, 1.0f));
  return scene;
}

/// The least of the floor beside the shadow of wallInTheSun(), which ends at z = 1.
float leastOfLitFloor(const FloatImage& seen, const Renderer& renderer) {
  float least = 1.0f;
  for (int x = -5; x <= 35; ++x) {
    for (int z = 16; z <= 30; ++z) {
      const glm::vec2 metres = 0.1f * glm::vec2(x, z);
      least = std::min(least, pixel(seen, pixelOfFloor(renderer, seen.size, metres.x, metres.y)).x);
    }
  }
  return least;
}

TEST_F(ShadowTest, SoftShadowsOfMapsOfEverySizeBeginAtTheContactAndLeaveThePlaneLit) {
  const Scene scene = wallInTheSun();
  const Camera camera = lookAt("", {2.5f, 4.0f, 6.0f}, {1.2f, 0.0f, 0.8f}, 45.0f);
  const glm::ivec2 size(160, 120);
  PictureSettings settings;
  settings.effect = kSoftShadowEffect;
  EffectInstance full(settings, kFullTechnique, EffectInstance::Coverage::unmeasured);
  EffectInstance mixed(settings, kMresTechnique, EffectInstance::Coverage::unmeasured);
  for (const int mapSize : {512, 2048, 8192}) {
    settings.renderer.shadowMapSize = mapSize;
    Renderer renderer(scene, profiler(), rendererSettings(settings));
    const mres::Frame frame = frameOf(renderer, renderer.drawGeometry(camera, size), size);
    const EffectInputs inputs = drawInputs(renderer, settings);
    ASSERT_EQ(inputs.shadow.mapSize, glm::ivec2(mapSize));
    for (EffectInstance* instance : {&full, &mixed}) {
      instance->setInputs(inputs);
      const FloatImage seen = readTexture(instance->render(frame), size, 1);
      for (const float x : {1.05f, 1.5f, 2.5f})
        EXPECT_LT(pixel(seen, pixelOfFloor(renderer, size, x, 0.0f)).x, 0.02f) << mapSize << " at " << x;
      EXPECT_GT(leastOfLitFloor(seen, renderer), 0.98f) << mapSize;
    }
  }
}

constexpr int kMapSize = 1024;

std::optional<ShadowFit> fitTo(const Camera& camera, const Bounds& scene, float reach = 0.0f) {
  const CameraView view(camera, kSize);
  return fitShadow(camera, view, static_cast<float>(kSize.x) / static_cast<float>(kSize.y), scene,
                   glm::normalize(glm::vec3(0.4f, 1.0f, 0.2f)), {kMapSize, reach});
}

TEST(ShadowFitTest, CoversWhatIsSeenAndEveryCaster) {
  const Bounds room{{-10.0f, 0.0f, -20.0f}, {10.0f, 6.0f, 20.0f}};
  const Camera camera = lookAt("", {1.0f, 2.0f, 5.0f}, {0.0f, 1.0f, -5.0f}, 60.0f);
  const auto fit = fitTo(camera, room);
  ASSERT_TRUE(fit.has_value());
  const CameraView view(camera, kSize);
  const glm::mat4 toMap = fit->view(kMapSize).clipMatrix(camera.position);
  for (int x = -20; x <= 20; ++x) {
    for (int z = -40; z <= 40; ++z) {
      const glm::vec3 point = 0.5f * glm::vec3(x, 0, z) - camera.position;
      const glm::vec4 clip = view.worldToClip * glm::vec4(point, 1.0f);
      if (glm::any(glm::greaterThan(glm::abs(glm::vec3(clip)), glm::vec3(clip.w)))) continue;
      const glm::vec3 inMap(toMap * glm::vec4(point, 1.0f));
      EXPECT_LT(std::max({std::abs(inMap.x), std::abs(inMap.y), std::abs(inMap.z)}), 1.0f) << x << ", " << z;
    }
  }
  const glm::vec3 roof = glm::vec3(0.0f, 6.0f, 0.0f) - camera.position;
  EXPECT_GT((toMap * glm::vec4(roof, 1.0f)).z, -1.0f);
}

TEST(ShadowFitTest, MovesByWholeTexels) {
  const Bounds ground{{-500.0f, 0.0f, -500.0f}, {500.0f, 10.0f, 500.0f}};
  Camera camera = lookAt("", {0.0f, 5.0f, 0.0f}, {10.0f, 0.0f, 0.0f}, 50.0f);
  camera.farPlane = 60.0f;
  const auto first = fitTo(camera, ground);
  ASSERT_TRUE(first.has_value());
  for (int step = 0; step < 20; ++step) {
    camera.position.x += 0.013f;
    camera.position.z -= 0.007f;
    const auto moved = fitTo(camera, ground);
    ASSERT_TRUE(moved.has_value());
    EXPECT_EQ(moved->extent, first->extent);
    EXPECT_EQ(moved->nearest, first->nearest);
    EXPECT_EQ(moved->farthest, first->farthest);
    const glm::dvec2 texels = (moved->corner - first->corner) / (first->extent / kMapSize);
    EXPECT_NEAR(texels.x, std::round(texels.x), 1e-6);
    EXPECT_NEAR(texels.y, std::round(texels.y), 1e-6);
  }
}

TEST(ShadowFitTest, CoversAsMuchMoreAsFiltersReach) {
  const Bounds room{{-10.0f, 0.0f, -20.0f}, {10.0f, 6.0f, 20.0f}};
  const Camera camera = lookAt("", {1.0f, 2.0f, 5.0f}, {0.0f, 1.0f, -5.0f}, 60.0f);
  const auto fit = fitTo(camera, room);
  const auto wide = fitTo(camera, room, 3.0f);
  ASSERT_TRUE(fit && wide);
  constexpr double kLargestStep = 1.125;  // the map without a reach may have been as much too large
  EXPECT_GT(wide->extent, fit->extent / kLargestStep + 6.0);
  EXPECT_LT(wide->corner.x, fit->corner.x);
  EXPECT_LT(wide->corner.y, fit->corner.y);
}

TEST(ShadowFitTest, IsNothingWhereNothingIsSeen) {
  const Bounds box{glm::vec3(-1.0f), glm::vec3(1.0f)};
  EXPECT_FALSE(fitTo(lookAt("", {0.0f, 0.0f, 5.0f}, {0.0f, 0.0f, 9.0f}, 60.0f), box).has_value());
  EXPECT_TRUE(fitTo(lookAt("", {0.0f, 0.0f, 5.0f}, {0.0f, 0.0f, 0.0f}, 60.0f), box).has_value());
  EXPECT_TRUE(fitTo(lookAt("", glm::vec3(0.0f), {0.0f, 0.0f, 1.0f}, 60.0f), box).has_value());  // from inside
}

TEST(ShadowFitTest, TakesInfiniteAndOrthographicCameras) {
  const Bounds box{glm::vec3(-1.0f), glm::vec3(1.0f)};
  Camera camera = lookAt("", {0.0f, 0.0f, 5.0f}, {0.0f, 0.0f, 0.0f}, 60.0f);
  camera.farPlane = 0.0f;
  const auto infinite = fitTo(camera, box);
  ASSERT_TRUE(infinite.has_value());
  EXPECT_LT(infinite->extent, 6.0);
  camera.farPlane = 20.0f;
  camera.orthographicHeight = 0.1f;
  const auto slim = fitTo(camera, box);
  ASSERT_TRUE(slim.has_value());
  EXPECT_LT(slim->extent, infinite->extent);
}

}  // namespace
}  // namespace host::test
