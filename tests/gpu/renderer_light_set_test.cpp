#include <gmock/gmock.h>

#include "host/renderer/lighting/environment.h"
#include "host/renderer/lighting/light_set.h"
#include "tests/gpu/renderer_support.h"

namespace host::test {
namespace {

Light lamp(float candela) {
  Light light;
  light.type = LightType::point;
  light.intensity = candela;
  return light;
}

Light spotlight(float candela) {
  Light light = lamp(candela);
  light.type = LightType::spot;
  return light;
}

TEST(LightSetTest, TheBrightestDirectionalLightCastsShadows) {
  const LightSet lights({sunAlong({0.0f, -1.0f, 0.0f}, 1.0f), lamp(50.0f), spotlight(60.0f),
                         sunAlong({1.0f, 0.0f, 0.0f}, 4.0f)});
  ASSERT_TRUE(lights.shadowCaster().has_value());
  EXPECT_EQ(lights.shadowCaster()->intensity, 4.0f);
  EXPECT_THAT(lights.lights(), testing::SizeIs(4));
  EXPECT_EQ(lights.params({}).lightIntensity[0].x, 4.0f) << "it comes first";
  EXPECT_EQ(lights.params({}).shadowedLights, 1);
}

TEST(LightSetTest, WithoutASunTheBrightestSpotLightCastsShadows) {
  const LightSet lights({spotlight(2.0f), lamp(50.0f), spotlight(5.0f)});
  ASSERT_TRUE(lights.shadowCaster().has_value());
  EXPECT_EQ(lights.shadowCaster()->intensity, 5.0f);
  EXPECT_FALSE(LightSet({lamp(1.0f)}).shadowCaster().has_value());
  EXPECT_EQ(LightSet({lamp(1.0f)}).params({}).shadowedLights, 0);
}

TEST(LightSetTest, LeavesOutBlackLightsAndCountsTheDimmestBeyondItsRoom) {
  std::vector<Light> many(MAX_LIGHTS + 5, lamp(2.0f));
  many[3] = lamp(1.0f);
  many[7] = lamp(0.0f);
  const LightSet lights(many);
  EXPECT_THAT(lights.lights(), testing::SizeIs(MAX_LIGHTS));
  EXPECT_EQ(lights.lights().back().intensity, 2.0f);
  EXPECT_EQ(lights.leftOut(), 4U);
}

TEST(LightSetTest, PositionsAreRelativeToTheCamera) {
  Light light = lamp(3.0f);
  light.position = {1.0f, 2.0f, 3.0f};
  light.range = 4.0f;
  const mres::params::LightParams params = LightSet({light}).params({0.5f, 0.0f, 5.0f});
  EXPECT_EQ(params.lightPosition[0], glm::vec4(0.5f, 2.0f, -2.0f, 0.25f));
  EXPECT_EQ(params.lightCount, 1);
}

TEST(EnvironmentTest, TheTintKeepsTheAmbientLightsMean) {
  Scene scene;
  scene.ambient = glm::vec3(0.4f);
  const mres::params::EnvironmentParams params = environmentParams(scene);
  const glm::vec3 mean = glm::vec3(params.ambientAbove + params.ambientBelow) * 0.5f;
  EXPECT_NEAR(luminance(mean), 0.4f, 1e-5f);
  EXPECT_GT(params.ambientAbove.b, params.ambientBelow.b);

  scene.sky.intensity = 3.0f;  // of the sky behind the scene alone
  EXPECT_EQ(environmentParams(scene).ambientAbove, params.ambientAbove);
  EXPECT_EQ(environmentParams(scene).skyZenith, 3.0f * params.skyZenith);
}

class ExposureTest : public RendererTest {
 protected:
  float exposureOf(const Scene& scene) { return Renderer(scene, profiler()).exposure(); }
};

TEST_F(ExposureTest, HalvesWhenAllLightsDouble) {
  Scene scene = darkScene();
  place(scene, cube(), chalk());
  EXPECT_EQ(exposureOf(scene), 1.0f);  // no light at all
  scene.ambient = glm::vec3(0.3f);
  scene.lights = {sunAlong({0.0f, -1.0f, 0.0f}, 3.0f), lamp(20.0f)};
  const float once = exposureOf(scene);
  scene.ambient *= 2.0f;
  for (Light& light : scene.lights) light.intensity *= 2.0f;
  EXPECT_NEAR(exposureOf(scene), 0.5f * once, 1e-6f);
}

TEST_F(ExposureTest, RendererTellsOfLightsLeftOut) {
  Scene scene = darkScene();
  scene.lights.assign(MAX_LIGHTS + 2, lamp(1.0f));
  EXPECT_EQ(Renderer(scene, profiler()).lightsLeftOut(), 2U);
}

}  // namespace
}  // namespace host::test
