#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "host/truth/ray_traced.h"
#include "tests/truth/analytic_scenes.h"

namespace host {
namespace {

using test::level;
using test::pointsOnFloor;
using test::sceneOf;

// Of 256 rays in a disk.
constexpr float kTolerance = 0.01f;

std::vector<float> visibility(const Scene& scene, const std::vector<glm::vec3>& points,
                              const LightRays& light = {}) {
  return traceVisibility(RayScene(scene), pointsOnFloor(points), light, [](auto&&...) {}).values.pixels;
}

/// The share of a unit disk on one side of a line at `distance` from its centre.
double shareOfDisk(double distance) {
  const double x = std::clamp(distance, -1.0, 1.0);
  return 0.5 + (x * std::sqrt(1.0 - x * x) + std::asin(x)) / std::numbers::pi;
}

TEST(RayTracedLight, ThePenumbraOfAnEdgeIsAsWideAsTheSun) {
  constexpr float kHeight = 3.0f;
  constexpr float kExtent = 0.02f;
  const Scene scene = sceneOf({level(0.0f, {0, 0}, 100.0f), level(kHeight, {-50, 0}, 50.0f)});
  const float radius = kHeight * kExtent;
  for (const float x : {-50.0f, -1.1f, -0.8f, -0.3f, 0.0f, 0.4f, 0.9f, 1.1f, 30.0f})
    EXPECT_NEAR(visibility(scene, {{x * radius, 1e-5f, 0}}, {.extent = kExtent})[0], shareOfDisk(x),
                kTolerance)
        << x;
}

TEST(RayTracedLight, ThePenumbraOfALampWidensWithTheDistanceFromWhatBlocks) {
  constexpr float kHeight = 6.0f;
  constexpr float kLampRadius = 0.1f;
  for (const float edge : {1.0f, 3.0f}) {
    const Scene scene = sceneOf({level(0.0f, {0, 0}, 100.0f), level(edge, {-50, 0}, 50.0f)});
    const LightRays lamp{.place = {0, kHeight, 0, 1}, .extent = kLampRadius};
    const float radius = kLampRadius * edge / (kHeight - edge);  // similar triangles
    for (const float x : {-30.0f, -1.1f, -0.6f, 0.0f, 0.3f, 0.9f, 1.1f, 30.0f})
      EXPECT_NEAR(visibility(scene, {{x * radius, 1e-5f, 0}}, lamp)[0], shareOfDisk(x), kTolerance) << x;
  }
}

TEST(RayTracedLight, NothingBehindALampHidesIt) {
  const Scene scene = sceneOf({level(0.0f, {0, 0}, 100.0f), level(3.0f, {0, 0}, 50.0f)});
  EXPECT_EQ(visibility(scene, {{1, 1e-4f, 0}}, {.place = {0, 2, 0, 1}, .extent = 0.1f})[0], 1.0f);
  EXPECT_EQ(visibility(scene, {{1, 1e-4f, 0}}, {.place = {0, 4, 0, 1}, .extent = 0.1f})[0], 0.0f);
}

TEST(RayTracedLight, WhatTheMapDoesNotCoverIsLit) {
  const Scene scene = sceneOf({level(0.0f, {0, 0}, 100.0f), level(3.0f, {0, 0}, 50.0f)});
  // World x and z from -1 to 1, y from 0 to 4.
  const glm::mat4 unitBox(glm::vec4(0.5f, 0, 0, 0), glm::vec4(0, 0.25f, 0, 0), glm::vec4(0, 0, 0.5f, 0),
                          glm::vec4(0.5f, 0, 0.5f, 1));
  EXPECT_EQ(visibility(scene, {{0.9f, 1e-4f, 0}, {1.1f, 1e-4f, 0}}, {.mapFromWorld = unitBox}),
            (std::vector<float>{0.0f, 1.0f}));
}

TEST(RayTracedLight, ABoxCastsUmbraAndPenumbraAlongTheLight) {
  const Scene scene = sceneOf({level(0.0f, {0, 0}, 100.0f), level(2.0f, {0, 0}, 0.5f)});
  const LightRays slanted{.place = glm::vec4(glm::normalize(glm::vec3(1, 1, 0)), 0)};
  // Light from +x at 45 degrees moves the shadow by its height towards -x.
  EXPECT_EQ(visibility(scene, {{-2, 1e-4f, 0}}, slanted)[0], 0.0f);
  EXPECT_EQ(visibility(scene, {{2, 1e-4f, 0}}, slanted)[0], 1.0f);
  EXPECT_EQ(visibility(scene, {{0, 1e-4f, 0}}, slanted)[0], 1.0f);
  EXPECT_NEAR(visibility(scene, {{-2.5f, 1e-4f, 0}}, slanted)[0], 0.5f, 0.05f);
}

TEST(RayTracedLight, WhatFacesAwayIsDark) {
  EXPECT_EQ(visibility(Scene(), {{0, 0, 0}}, {.place = {0, -1, 0, 0}})[0], 0.0f);
  EXPECT_EQ(visibility(Scene(), {{0, 0, 0}}, {.place = {0, 1, 0, 0}})[0], 1.0f);
}

TEST(RayTracedLight, InstancesHideWhereTheyArePlaced) {
  Scene scene = sceneOf({level(2.0f, {0, 0}, 0.5f), level(0.0f, {0, 0}, 100.0f)});
  scene.instances[0].transform = glm::mat4(glm::vec4(-1, 0, 0, 0), glm::vec4(0, 1, 0, 0),
                                           glm::vec4(0, 0, 1, 0), glm::vec4(7, 0, 0, 1));  // mirrored
  EXPECT_EQ(visibility(scene, {{0, 1e-4f, 0}, {7, 1e-4f, 0}}), (std::vector<float>{1.0f, 0.0f}));
}

/// A quad over the floor whose material lets light through in its left half, u < 1/2.
Scene halfMasked(AlphaMode mode) {
  Scene scene = sceneOf({level(2.0f, {0, 0}, 1.0f, 0)});
  test::addTexturedMaterial(scene, mode, {0, 255});
  return scene;
}

TEST(RayTracedLight, AlphaMasksLetLightThroughTheirHoles) {
  const std::vector<glm::vec3> points{{-0.5f, 0, 0}, {0.5f, 0, 0}};
  EXPECT_EQ(visibility(halfMasked(AlphaMode::mask), points), (std::vector<float>{1.0f, 0.0f}));
  EXPECT_EQ(visibility(halfMasked(AlphaMode::opaque), points), (std::vector<float>{0.0f, 0.0f}));
}

TEST(RayTracedLight, BlendedSurfacesCastNoShadow) {
  EXPECT_EQ(visibility(halfMasked(AlphaMode::blend), {{0.5f, 0, 0}}), std::vector<float>{1.0f});
}

}  // namespace
}  // namespace host
