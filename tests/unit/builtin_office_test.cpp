#include <gtest/gtest.h>

#include "host/scene/builtin/builtin_scenes.h"
#include "tests/unit/builtin_scene_checks.h"

namespace host {
namespace {

const Scene& office() {
  static const Scene scene = makeOffice();
  return scene;
}

TEST(Office, HasAbout20000Triangles) {
  EXPECT_GE(triangleCount(office()), 18000U);
  EXPECT_LE(triangleCount(office()), 22000U);
}

TEST(Office, IsSound) {
  test::expectSound(office());
}

TEST(Office, HasEightCamerasInside) {
  test::expectEightCameras(office());
}

TEST(Office, IsTheSameEveryTime) {
  test::expectSame(office(), makeOffice());
}

TEST(Office, HasASunThatShinesDownIntoTheRoom) {
  ASSERT_FALSE(office().lights.empty());
  EXPECT_EQ(office().lights[0].type, LightType::directional);
  EXPECT_LT(office().lights[0].direction.y, 0.0f);
  EXPECT_GT(office().lights[0].direction.z, 0.0f) << "the windows are in the wall to -Z";
}

}  // namespace
}  // namespace host
