#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

#include "host/scene/builtin/builtin_scenes.h"
#include "host/scene/builtin/hall_measures.h"
#include "tests/unit/builtin_scene_checks.h"
#include "tests/unit/mesh_checks.h"

namespace host {
namespace {

const Scene& theHall() {
  static const Scene scene = makeHall();
  return scene;
}

TEST(Hall, HasAbout183000Triangles) {
  EXPECT_GE(triangleCount(theHall()), 175000U);
  EXPECT_LE(triangleCount(theHall()), 190000U);
}

TEST(Hall, IsSound) {
  test::expectSound(theHall());
}

/// What encloses the hall leaves no gap for light.
TEST(Hall, WallsAndRoofsAreClosed) {
  int checked = 0;
  for (const Mesh& mesh : theHall().meshes) {
    const bool encloses = mesh.name.find("wall") != std::string::npos ||
                          mesh.name.find("floor") != std::string::npos ||
                          mesh.name.find("roof") != std::string::npos;
    if (!encloses) continue;
    ++checked;
    EXPECT_EQ(test::leakOf(mesh), "") << mesh.name;
    EXPECT_GT(test::volumeOf(mesh), 0.0) << mesh.name;
  }
  EXPECT_GE(checked, 6);
}

const Mesh& meshNamed(const std::string& name) {
  const auto found = std::ranges::find(theHall().meshes, name, &Mesh::name);
  if (found == theHall().meshes.end()) throw std::runtime_error("the hall has no " + name);
  return *found;
}

/// The bands around the arches lie on the wall, not in the openings. Keystones hang into those at the crown,
/// the imposts below the springing stand a little in them.
TEST(Hall, ArchivoltsLeaveTheArchesOpen) {
  constexpr float kKeystoneHalfWidth = 0.2f;
  constexpr float kImpostTop = 0.01f;
  for (const Vertex& vertex : meshNamed("arch mouldings").vertices) {
    if (std::abs(vertex.position.z) < kKeystoneHalfWidth) continue;
    for (const float springing : {hall::kSpringing, hall::kUpperSpringing}) {
      const float height = vertex.position.y - springing;
      if (height < kImpostTop) continue;
      ASSERT_GE(std::hypot(vertex.position.z, height), hall::kArchRadius)
          << vertex.position.x << ' ' << vertex.position.y << ' ' << vertex.position.z;
    }
  }
}

TEST(Hall, HasEightCamerasInside) {
  test::expectEightCameras(theHall());
}

TEST(Hall, IsTheSameEveryTime) {
  test::expectSame(theHall(), makeHall());
}

}  // namespace
}  // namespace host
