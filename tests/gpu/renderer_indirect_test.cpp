// Ambient light with and without an effect that finds it: the same where nothing hides any.
#include <algorithm>
#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <vector>

#include "effects/common/sample_points.h"
#include "host/measure/effect_instance.h"
#include "host/renderer/bindings.h"
#include "host/renderer/embedded_shaders.h"
#include "host/truth/surface_frame.h"
#include "mres/gl/uniform_buffer.h"
#include "shaders/host/environment_params.h"
#include "tests/gpu/renderer_support.h"
#include "tests/support/glsl_function.h"

namespace host::test {
namespace {

/// Half floats, and the mean height of the effect's points, which is not quite 2/3.
constexpr double kTolerance = 4e-3;

/// Ambient light that comes more from above than from below.
Scene unevenlyLit() {
  Scene scene = darkScene();
  scene.ambient = glm::vec3(0.5f);
  scene.sky = {glm::vec3(1.0f), glm::vec3(1.0f), glm::vec3(0.0f), 0.0f};
  return scene;
}

glm::mat4 tilted(float degrees) {
  return glm::rotate(glm::mat4(1.0f), glm::radians(degrees), glm::vec3(1.0f, 0.0f, 0.0f));
}

/// That looks at the origin, where a square tilted so is.
Camera cameraBefore(const glm::mat4& tilt) {
  const glm::vec3 normal(tilt[2]);
  return lookAt("before", 3.0f * normal + glm::vec3(0.0f, 0.0f, 1.5f), glm::vec3(0.0f), 40.0f);
}

/// A white floor before a red wall that the sun lights.
Scene redWall() {
  Scene scene = darkScene();
  Material red = chalk();
  red.baseColor = {1.0f, 0.0f, 0.0f, 1.0f};
  place(scene, square(), chalk(), tilted(-90.0f));
  place(scene, square(), red, glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 1.0f, -1.0f)));
  scene.lights.push_back(sunAlong(glm::normalize(glm::vec3(0.0f, -0.3f, -1.0f)), 3.0f));
  return scene;
}

Camera cameraBeforeWall() {
  return lookAt("", {0.0f, 1.5f, 1.5f}, {0.0f, 0.2f, -0.8f}, 40.0f);
}

/// The pixel, from the upper left, that shows a point of the world.
glm::ivec2 pixelShowing(const Camera& camera, glm::vec3 point) {
  const float aspect = static_cast<float>(kSize.x) / static_cast<float>(kSize.y);
  const glm::vec4 clip = projectionMatrix(camera, aspect) * viewMatrix(camera) * glm::vec4(point, 1.0f);
  const glm::vec2 window = glm::vec2(clip.x, -clip.y) / clip.w * 0.5f + 0.5f;
  return {window * glm::vec2(kSize)};
}

class LightingIndirectTest : public RendererTest {
 protected:
  /// Linear radiance.
  struct Pictures {
    FloatImage with;
    FloatImage without;
  };

  /// With SSGI and without.
  Pictures draw(const Scene& scene, const Camera& camera, float stops = 0.0f) {
    Renderer renderer(scene, profiler(), {.exposureCompensation = stops});
    EXPECT_NE(renderer.exposure(), 1.0f) << "would hide a factor of it";
    const mres::Frame frame = frameOf(renderer, renderer.drawGeometry(camera, kSize), kSize);
    EffectInstance instance(settings_, kFullTechnique, EffectInstance::Coverage::unmeasured);
    instance.setInputs(drawInputs(renderer, settings_));
    const GLuint values = instance.render(frame);
    Pictures pictures;
    pictures.with = readTexture(renderer.drawLighting(screenEffects(settings_, values)), kSize, 3);
    pictures.without = readTexture(renderer.drawLighting({}), kSize, 3);
    return pictures;
  }

  void expectAlike(const Pictures& pictures) {
    const glm::vec4 without = centre(pictures.without);
    EXPECT_GT(without.g, 0.2f);
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(centre(pictures.with)[channel], without[channel], kTolerance);
  }

  const PictureSettings settings_ = [] {
    PictureSettings settings;
    settings.effect = kSsgiEffect;
    return settings;
  }();
};

TEST_F(LightingIndirectTest, OpenSurfacesLookAsWithoutTheEffect) {
  for (const float degrees : {-90.0f, -45.0f, 0.0f, 30.0f, 90.0f}) {
    SCOPED_TRACE(degrees);
    Scene scene = unevenlyLit();
    place(scene, square(), chalk(), tilted(degrees));
    expectAlike(draw(scene, cameraBefore(tilted(degrees))));
  }
}

TEST_F(LightingIndirectTest, NormalMapsShowAsWithoutTheEffect) {
  const auto drawWithNormal = [this](const std::vector<std::uint8_t>& texel) {
    Scene scene = unevenlyLit();
    Material material = chalk();
    material.normalTexture.texture = addTexture(scene, {1, 1}, texel);
    place(scene, square(), material);
    return draw(scene, frontCamera());
  };
  const Pictures up = drawWithNormal({128, 204, 230, 255});
  const Pictures down = drawWithNormal({128, 52, 230, 255});
  expectAlike(up);
  expectAlike(down);
  EXPECT_GT(centre(up.without).g, centre(down.without).g + 0.05f);
}

TEST_F(LightingIndirectTest, ARedWallTintsTheFloorBesideIt) {
  const Camera camera = cameraBeforeWall();
  const Pictures pictures = draw(redWall(), camera);
  const glm::ivec2 floor = pixelShowing(camera, {0.0f, 0.0f, -0.6f});
  const glm::vec4 bounced = pixel(pictures.with, floor) - pixel(pictures.without, floor);
  EXPECT_GT(bounced.r, 0.02f);
  EXPECT_LT(bounced.g, 0.1f * bounced.r);
}

TEST_F(LightingIndirectTest, TheDisplaysExposureChangesNothing) {
  const Pictures usual = draw(redWall(), cameraBeforeWall());
  EXPECT_EQ(draw(redWall(), cameraBeforeWall(), 6.0f).with.pixels, usual.with.pixels);
}

TEST_F(LightingIndirectTest, TransparentSurfacesSendNothing) {
  Scene scene = unevenlyLit();
  place(scene, square(), chalk());
  Material glass = chalk();
  glass.emissive = {9.0f, 0.0f, 0.0f};
  glass.alphaMode = AlphaMode::blend;
  place(scene, square(), glass, glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, 0.5f)));
  Renderer renderer(scene, profiler());
  renderer.drawGeometry(frontCamera(), kSize);
  const EffectInputs inputs = drawInputs(renderer, settings_);
  EXPECT_LT(centre(readTexture(inputs.ssgi.radiance, kSize, 3)).r, 1.0f);
  EXPECT_GT(centre(readTexture(renderer.drawLighting({}), kSize, 3)).r, 8.0f);
}

TEST_F(LightingIndirectTest, TransparentSurfacesReceiveTheSameAmbientLight) {
  Scene opaque = unevenlyLit();
  place(opaque, square(), chalk(), tilted(-60.0f));
  Scene transparent = opaque;
  transparent.materials[0].alphaMode = AlphaMode::blend;  // and an alpha of 1
  const Camera camera = cameraBefore(tilted(-60.0f));
  EXPECT_NEAR(centre(drawLit(transparent, camera)).g, centre(drawLit(opaque, camera)).g, kTolerance);
}

// As under a desk: what no diffuse light reaches, no sky is mirrored in.
TEST_F(LightingIndirectTest, MetalsMirrorAsMuchAmbientLightAsArrives) {
  Scene scene = unevenlyLit();
  Material metal = chalk();
  metal.metallic = 1.0f;
  place(scene, square(), metal);
  Renderer renderer(scene, profiler());
  renderer.drawGeometry(frontCamera(), kSize);
  const double open = centre(readTexture(renderer.drawLighting({}), kSize, 3)).g;
  EXPECT_GT(open, 0.1);
  for (const float share : {0.0f, 0.25f, 1.0f, 3.0f}) {
    // Half from above and half from below reach a surface that stands upright.
    const glm::vec4 arriving(0.5f * share * renderer.exposure());
    const std::vector<glm::vec4> texels(static_cast<std::size_t>(kSize.x) * kSize.y, arriving);
    const mres::gl::Texture2D indirect(GL_RGBA32F, kSize, "indirect", 1, texels.data());
    const double lit = centre(readTexture(renderer.drawLighting({.indirect = indirect.id()}), kSize, 3)).g;
    EXPECT_NEAR(lit, std::min(share, 1.0f) * open, kTolerance) << share;
  }
}

TEST_F(LightingIndirectTest, DiffuseAmbientLightIsTheMeanOfWhatComesFromTheHemisphere) {
  mres::gl::UniformBuffer<mres::params::EnvironmentParams> block;
  mres::params::EnvironmentParams environment{};
  environment.ambientAbove = {1.0f, 0.5f, 0.2f, 0.0f};
  environment.ambientBelow = {0.0f, 0.3f, 0.9f, 0.0f};
  block.upload(environment);
  std::vector<glm::vec4> normals;
  for (const glm::vec3 normal : {glm::vec3(0, 1, 0), {0, -1, 0}, {1, 0, 0}, {0.6f, -0.48f, 0.64f}})
    normals.emplace_back(normal, 0.0f);
  const std::vector<glm::vec4> values = mres::test::evaluate(
      mres::gl::preprocess(shaderLibrary(), "host/environment.glsl").text, "vec4(diffuseAmbient(a.xyz), 1.0)",
      normals, {}, [&](const mres::gl::Program& program) {
        program.setBlockBinding("EnvironmentParams", bindings::kEnvironment);
        block.bind(bindings::kEnvironment);
      });
  for (std::size_t i = 0; i < normals.size(); ++i) {
    glm::dvec4 mean(0.0);
    constexpr int kPoints = 16384;  // whose mean direction is 2e-3 off the normal
    for (const glm::vec3 point : mres::hemispherePoints(kPoints, 0)) {
      const float height = (frameAround(glm::vec3(normals[i])) * glm::normalize(point)).y;
      mean += glm::dvec4(glm::mix(environment.ambientBelow, environment.ambientAbove, 0.5f + 0.5f * height));
    }
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(static_cast<double>(values[i][channel]), mean[channel] / kPoints, kTolerance) << i;
  }
}

}  // namespace
}  // namespace host::test
