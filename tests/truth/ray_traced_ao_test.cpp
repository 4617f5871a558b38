#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <stdexcept>

#include "host/truth/ray_traced.h"
#include "tests/truth/analytic_scenes.h"

namespace host {
namespace {

using test::level;
using test::pointsOnFloor;
using test::quad;
using test::sceneOf;

const WorkObserver kSilent = [](auto&&...) {};

// Of 256 stratified rays.
constexpr float kTolerance = 0.02f;

Mesh floorMesh() {
  return level(0.0f, {0.0f, 0.0f}, 100.0f);
}

/// In the plane x = 0.
Mesh tallWall() {
  return quad({{{0, 0, 100}, {0, 0, -100}, {0, 100, -100}, {0, 100, 100}}});
}

std::vector<float> accessibility(const Scene& scene, const std::vector<glm::vec3>& points,
                                 const OcclusionRays& rays) {
  return traceAccessibility(RayScene(scene), pointsOnFloor(points), rays, kSilent).values.pixels;
}

TEST(RayTracedAo, APlaneIsOpen) {
  for (const float pixel :
       accessibility(sceneOf({floorMesh()}), {{0, 1e-4f, 0}, {5, 1e-4f, 3}, {-9, 1e-4f, 1}}, {}))
    EXPECT_EQ(pixel, 1.0f);
}

TEST(RayTracedAo, WithoutSurfacesAllIsOpen) {
  EXPECT_EQ(accessibility(Scene(), {{0, 0, 0}}, {}), std::vector<float>{1.0f});
}

TEST(RayTracedAo, AtTheFootOfAWallHalfIsHidden) {
  const Scene scene = sceneOf({floorMesh(), tallWall()});
  for (const float x : {1e-3f, -1e-3f})  // either side of it hides
    EXPECT_NEAR(accessibility(scene, {{x, 1e-4f, 0}}, {.radius = 10.0f})[0], 0.5f, kTolerance);
}

/// Of the points in the cosine-weighted hemisphere over a floor, at uniform distances of up to 1 metre, the
/// share beyond a plane at `distance`: each direction is cut at distance / its slope towards the plane.
double shareBeyondWall(double distance) {
  constexpr int kSteps = 1000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const double sine = std::sqrt((i + 0.5) / kSteps);
      const double towards = sine * std::cos(2.0 * std::numbers::pi * (j + 0.5) / kSteps);
      if (towards > distance) sum += 1.0 - distance / towards;
    }
  return sum / kSteps / kSteps;
}

TEST(RayTracedAo, FartherFromAWallLessIsHidden) {
  const Scene scene = sceneOf({floorMesh(), tallWall()});
  for (const float distance : {0.1f, 0.3f, 0.6f})
    EXPECT_NEAR(accessibility(scene, {{distance, 1e-4f, 0}}, {.radius = 1.0f})[0],
                1.0 - shareBeyondWall(distance), kTolerance)
        << distance;
  EXPECT_EQ(accessibility(scene, {{1.01f, 1e-4f, 0}}, {.radius = 1.0f})[0], 1.0f);
}

TEST(RayTracedAo, IntensityMultipliesAndNothingIsBelowZero) {
  const Scene scene = sceneOf({floorMesh(), tallWall()});
  const auto at = [&](float intensity) {
    return accessibility(scene, {{1e-3f, 1e-4f, 0}}, {.radius = 10.0f, .intensity = intensity})[0];
  };
  EXPECT_NEAR(at(0.5f), 0.75f, kTolerance);
  EXPECT_EQ(at(0.0f), 1.0f);
  EXPECT_EQ(at(4.0f), 0.0f);
}

TEST(RayTracedAo, BackgroundIsOpen) {
  GridSurfaces surfaces = pointsOnFloor({{1e-3f, 1e-4f, 0}, {1e-3f, 1e-4f, 0}});
  surfaces.points[1].background = true;
  const Scene walls = sceneOf({floorMesh(), tallWall()});
  const Truth truth = traceAccessibility(RayScene(walls), surfaces, {.radius = 10.0f}, kSilent);
  EXPECT_LT(truth.values.pixels[0], 0.6f);
  EXPECT_EQ(truth.values.pixels[1], 1.0f);
}

TEST(RayTracedAo, ManyPointsAreAllEvaluated) {
  constexpr int kRows = 2500;
  GridSurfaces surfaces{{{1, kRows}, 1}, {}};
  for (int row = 0; row < kRows; ++row)
    surfaces.points.push_back({{row % 2 == 0 ? 1e-3f : 20.0f, 1e-4f, 0}, {0, 1, 0}, false});
  const Scene walls = sceneOf({floorMesh(), tallWall()});
  int observed = 0;
  const Truth truth = traceAccessibility(RayScene(walls), surfaces, {.radius = 10.0f},
                                         [&](double, const std::string&) { ++observed; });
  for (int row = 0; row < kRows; ++row)
    EXPECT_NEAR(truth.values.pixels[row], row % 2 == 0 ? 0.5f : 1.0f, 0.1f) << row;
  EXPECT_GT(observed, 1);
}

TEST(RayTracedAo, ObserversCanStopIt) {
  const Scene scene = sceneOf({floorMesh()});
  EXPECT_THROW(traceAccessibility(RayScene(scene), pointsOnFloor({{0, 1e-4f, 0}}), {},
                                  [](double, const std::string&) { throw std::runtime_error("stop"); }),
               std::runtime_error);
}

}  // namespace
}  // namespace host
