#include "host/measure/camera_path.h"

#include <cmath>
#include <gtest/gtest.h>

namespace host {
namespace {

const Bounds kRoom{glm::vec3(-10.0f), glm::vec3(10.0f)};

Camera start() {
  return lookAt("start", {1.0f, 2.0f, 3.0f}, {-2.0f, 1.0f, -5.0f}, 60.0f);
}

glm::vec3 forwardOf(const Camera& camera) {
  return camera.orientation * glm::vec3(0.0f, 0.0f, -1.0f);
}

float degreesBetween(const Camera& a, const Camera& b) {
  return glm::degrees(2.0f * std::asin(0.5f * glm::distance(forwardOf(a), forwardOf(b))));
}

TEST(CameraPath, BeginsAtTheCamera) {
  const Camera first = cameraAt(start(), {}, kRoom, 0);
  EXPECT_EQ(first.position, start().position);
  EXPECT_LT(degreesBetween(first, start()), 1e-4f);
  EXPECT_EQ(first.verticalFov, start().verticalFov);
  EXPECT_EQ(first.nearPlane, start().nearPlane);
}

TEST(CameraPath, GoesForwardAndTurnsInEvenSteps) {
  const CameraPath path;
  for (int frame = 1; frame < path.frames; ++frame) {
    const Camera before = cameraAt(start(), path, kRoom, frame - 1);
    const Camera after = cameraAt(start(), path, kRoom, frame);
    EXPECT_NEAR(glm::dot(after.position - before.position, forwardOf(start())), path.metres, 1e-5f) << frame;
    EXPECT_NEAR(degreesBetween(before, after), path.degrees, 1e-3f) << frame;
  }
}

TEST(CameraPath, NeverStandsStillNorGoesFar) {
  const CameraPath path;
  for (int frame = 1; frame < 400; ++frame) {
    const Camera before = cameraAt(start(), path, kRoom, frame - 1);
    const Camera after = cameraAt(start(), path, kRoom, frame);
    EXPECT_NEAR(glm::distance(before.position, after.position), path.metres, 1e-5f) << frame;
    EXPECT_NEAR(degreesBetween(before, after), path.degrees, 1e-3f) << frame;
    EXPECT_LT(glm::distance(after.position, start().position), 8.01f * path.metres) << frame;
    EXPECT_LT(degreesBetween(after, start()), 11.01f * path.degrees) << frame;
  }
}

TEST(CameraPath, TakesSmallerStepsInSmallScenes) {
  const Bounds thimble{glm::vec3(0.0f), glm::vec3(0.0f, 0.02f, 0.0f)};
  const Camera end = cameraAt(start(), {}, thimble, 7);
  EXPECT_NEAR(glm::distance(end.position, start().position), 7.0f * 0.00002f, 1e-6f);
}

TEST(CameraPath, CanBeAStandstill) {
  const Camera camera = cameraAt(start(), {.metres = 0.0f, .degrees = 0.0f}, kRoom, 5);
  EXPECT_EQ(camera.position, start().position);
  EXPECT_EQ(camera.orientation, start().orientation);
}

}  // namespace
}  // namespace host
