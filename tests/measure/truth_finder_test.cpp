// Truths of pictures that the host's renderer draws: what they are of, and that they agree where they must.
#include "host/measure/truth_finder.h"

#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/measure/effect_instance.h"
#include "host/platform/gl_context.h"

namespace host {
namespace {

using testing::Each;
using testing::ElementsAre;

constexpr glm::ivec2 kSize(320, 120);

/// A block on a floor before a wall, in the sun, seen from the front and above: screen space shows all that
/// matters.
Scene blockOnFloor() {
  Mesh face;
  face.vertices = {
      {.position = {-1, 0, 1}}, {.position = {1, 0, 1}}, {.position = {1, 0, -1}}, {.position = {-1, 0, -1}}};
  face.indices = {0, 1, 2, 0, 2, 3};
  const auto placed = [](const glm::mat3& axes, glm::vec3 at) {
    return Instance{
        0, glm::mat4(glm::vec4(axes[0], 0), glm::vec4(axes[1], 0), glm::vec4(axes[2], 0), glm::vec4(at, 1))};
  };
  const glm::mat3 lying(1.0f);
  const glm::mat3 standing(glm::vec3(1, 0, 0), glm::vec3(0, 0, 1), glm::vec3(0, -1, 0));  // faces +z
  Scene scene;
  scene.name = "block";
  scene.meshes = {face};
  scene.instances = {placed(10.0f * lying, {0, 0, 0}), placed(10.0f * standing, {0, 0, -2}),
                     placed(0.5f * lying, {0, 1, -1.5f}), placed(0.5f * standing, {0, 0.5f, -1})};
  scene.cameras = {lookAt("front", {0, 3, 5}, {0, 0.5f, -1.5f}, 45.0f)};
  scene.lights.emplace_back().direction = glm::normalize(glm::vec3(1, -2, -1));
  return scene;
}

/// The same, lit by a lamp from about where the sun is.
Scene blockUnderALamp() {
  Scene scene = blockOnFloor();
  Light& lamp = scene.lights.front();
  lamp.type = LightType::spot;
  lamp.position = glm::vec3(0, 1, -1.5f) - 4.0f * lamp.direction;
  lamp.intensity = 100.0f;
  return scene;
}

class Truths : public testing::Test {
 protected:
  std::vector<Truth> find(const Scene& scene, const std::string& effect, glm::ivec2 size = kSize) {
    PictureSettings settings;
    settings.effect = effect;
    settings.softShadows.contactHardening = true;
    settings.softShadows.lightAngle = 4.0f;
    settings.softShadows.lightRadius = 0.1f;
    return findWith(settings, scene, size);
  }
  std::vector<Truth> findWith(const PictureSettings& settings, const Scene& scene, glm::ivec2 size = kSize) {
    Renderer renderer(scene, profiler_);
    const mres::Frame frame = frameOf(renderer, renderer.drawGeometry(scene.cameras[0], size), size);
    return TruthFinder(scene, settings).find(frame, drawInputs(renderer, settings), [](auto&&...) {});
  }
  std::vector<std::string> namesOf(const Scene& scene, const std::string& effect) {
    std::vector<std::string> names;
    for (const Truth& truth : find(scene, effect)) {
      EXPECT_GE(truth.count, truth.name == "converged" ? 4096 : 256) << effect;
      EXPECT_EQ(truth.values.size, truth.grid.size()) << effect;
      for (const float value : truth.values.pixels) EXPECT_TRUE(std::isfinite(value)) << effect;
      names.push_back(truth.name);
    }
    return names;
  }

  GlContext context_;
  mres::gl::Profiler profiler_;
};

TEST_F(Truths, AreThoseThatAnEffectHas) {
  const Scene scene = blockOnFloor();
  EXPECT_THAT(namesOf(scene, "ssao"), ElementsAre("converged", "ray_traced"));
  EXPECT_THAT(namesOf(scene, "ssm"), ElementsAre("converged", "ray_traced"));
  EXPECT_THAT(namesOf(scene, "ssgi"), ElementsAre("converged"));
  EXPECT_THAT(namesOf(blockUnderALamp(), "ssm"), ElementsAre("converged", "ray_traced"));
}

TEST_F(Truths, ConvergeWithMoreSamplesThanThePictureHas) {
  PictureSettings settings;
  settings.effect = "ssgi";
  settings.ssgi.samples = 4224;
  EXPECT_GE(findWith(settings, blockOnFloor()).at(0).count, 4 * 4224);
}

TEST_F(Truths, LieBetweenThePixelsOfCoarseLevels) {
  const glm::ivec2 size(480, 240);  // more pixels than are traced
  for (const Truth& truth : findWith({}, blockOnFloor(), size)) {
    std::array<int, 8> columns{};  // by their place among eight, the stride of the coarsest level
    for (int x = 0; x < truth.grid.size().x; ++x) ++columns.at(truth.grid.pixel({x, 0}).x % 8);
    EXPECT_THAT(columns, Each(truth.grid.size().x / 8)) << truth.name;
  }
}

TEST_F(Truths, TheLastSeedIsFollowedByTheFirst) {
  PictureSettings settings;
  settings.ssao.seed = 65535;
  const Scene scene = blockOnFloor();
  EXPECT_EQ(findWith(settings, scene).size(), 2U);
}

TEST_F(Truths, WithoutALightThereIsNothingToTrace) {
  Scene scene = blockOnFloor();
  scene.lights.clear();
  EXPECT_THAT(namesOf(scene, "ssm"), ElementsAre("converged"));
}

/// Of the values at the pixels of the converged reference, which the ray-traced picture of this size has all.
double differenceOf(const std::vector<Truth>& truths) {
  const Truth& converged = truths.at(0);
  const Truth& rayTraced = truths.at(1);
  EXPECT_EQ(rayTraced.grid.size(), kSize);
  const FloatImage traced = valuesAt(converged.grid, rayTraced.values);
  double squares = 0.0;
  for (std::size_t i = 0; i < traced.pixels.size(); ++i)
    squares += std::pow(traced.pixels[i] - converged.values.pixels[i], 2.0);
  return std::sqrt(squares / static_cast<double>(traced.pixels.size()));
}

TEST_F(Truths, AgreeWhereScreenSpaceShowsAllThatMatters) {
  const Scene scene = blockOnFloor();
  EXPECT_LT(differenceOf(find(scene, "ssao")), 0.03);
  EXPECT_LT(differenceOf(find(scene, "ssm")), 0.06);
  EXPECT_LT(differenceOf(find(blockUnderALamp(), "ssm")), 0.06);
}

TEST_F(Truths, ShowTheSceneAndNotAConstant) {
  const Scene scene = blockOnFloor();
  for (const char* effect : {"ssao", "ssm"})
    for (const Truth& truth : find(scene, effect, {640, 360})) {
      const auto [least, greatest] = std::ranges::minmax(truth.values.pixels);
      EXPECT_LT(least, 0.7f) << effect << ' ' << truth.name;
      EXPECT_GT(greatest, 0.99f) << effect << ' ' << truth.name;
    }
}

}  // namespace
}  // namespace host
