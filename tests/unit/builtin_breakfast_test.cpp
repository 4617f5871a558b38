#include <gtest/gtest.h>

#include "host/scene/builtin/builtin_scenes.h"
#include "tests/unit/builtin_scene_checks.h"

namespace host {
namespace {

const Scene& breakfast() {
  static const Scene scene = makeBreakfast();
  return scene;
}

TEST(Breakfast, HasAbout270000Triangles) {
  EXPECT_GE(triangleCount(breakfast()), 260000U);
  EXPECT_LE(triangleCount(breakfast()), 280000U);
}

TEST(Breakfast, IsSound) {
  test::expectSound(breakfast());
}

TEST(Breakfast, HasEightCamerasInside) {
  test::expectEightCameras(breakfast());
}

TEST(Breakfast, IsTheSameEveryTime) {
  test::expectSame(breakfast(), makeBreakfast());
}

TEST(Breakfast, HasASunThatShinesDownIntoTheRoom) {
  ASSERT_FALSE(breakfast().lights.empty());
  EXPECT_EQ(breakfast().lights[0].type, LightType::directional);
  EXPECT_LT(breakfast().lights[0].direction.y, 0.0f);
  EXPECT_GT(breakfast().lights[0].direction.z, 0.0f) << "the windows are in the wall to -Z";
}

}  // namespace
}  // namespace host
