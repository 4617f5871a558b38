#include <gtest/gtest.h>
#include <set>

#include "host/scene/builtin/builtin_scenes.h"
#include "tests/unit/mesh_checks.h"

namespace host {
namespace {

const Scene& hall() {
  static const Scene scene = makeHall();
  return scene;
}

TEST(Hall, HasAbout183000Triangles) {
  EXPECT_GE(triangleCount(hall()), 175000U);
  EXPECT_LE(triangleCount(hall()), 190000U);
}

TEST(Hall, MeshesAreSound) {
  for (const Mesh& mesh : hall().meshes) EXPECT_EQ(test::faultOf(mesh), "");
}

/// What encloses the hall leaves no gap for light.
TEST(Hall, WallsAndRoofsAreClosed) {
  int checked = 0;
  for (const Mesh& mesh : hall().meshes) {
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

TEST(Hall, ReferencesAreValid) {
  const Scene& scene = hall();
  for (const Instance& instance : scene.instances) {
    ASSERT_GE(instance.mesh, 0);
    ASSERT_LT(static_cast<std::size_t>(instance.mesh), scene.meshes.size());
  }
  for (const Mesh& mesh : scene.meshes) {
    ASSERT_GE(mesh.material, 0) << mesh.name;
    ASSERT_LT(static_cast<std::size_t>(mesh.material), scene.materials.size()) << mesh.name;
  }
  const auto textures = static_cast<int>(scene.textures.size());
  for (const Material& material : scene.materials) {
    EXPECT_LT(material.baseColorTexture.texture, textures) << material.name;
    EXPECT_LT(material.normalTexture.texture, textures) << material.name;
  }
  for (const Texture& texture : scene.textures) {
    ASSERT_GE(texture.image, 0);
    ASSERT_LT(static_cast<std::size_t>(texture.image), scene.images.size());
  }
}

TEST(Hall, HasEightDistinctCamerasInside) {
  const Bounds bounds = boundsOf(hall());
  std::set<std::string> names;
  for (const Camera& camera : hall().cameras) {
    names.insert(camera.name);
    EXPECT_TRUE(glm::all(glm::greaterThan(camera.position, bounds.min))) << camera.name;
    EXPECT_TRUE(glm::all(glm::lessThan(camera.position, bounds.max))) << camera.name;
    EXPECT_GE(glm::degrees(camera.verticalFov), 45.0f) << camera.name;
    EXPECT_LE(glm::degrees(camera.verticalFov), 65.1f) << camera.name;
  }
  EXPECT_EQ(hall().cameras.size(), 8U);
  EXPECT_EQ(names.size(), 8U);
}

TEST(Hall, IsTheSameEveryTime) {
  const Scene again = makeHall();
  ASSERT_EQ(again.meshes.size(), hall().meshes.size());
  for (std::size_t i = 0; i < again.meshes.size(); ++i) {
    EXPECT_EQ(again.meshes[i].indices, hall().meshes[i].indices);
    ASSERT_EQ(again.meshes[i].vertices.size(), hall().meshes[i].vertices.size());
    for (std::size_t k = 0; k < again.meshes[i].vertices.size(); ++k) {
      ASSERT_EQ(again.meshes[i].vertices[k].position, hall().meshes[i].vertices[k].position);
      ASSERT_EQ(again.meshes[i].vertices[k].normal, hall().meshes[i].vertices[k].normal);
    }
  }
  for (std::size_t i = 0; i < again.images.size(); ++i)
    EXPECT_EQ(again.images[i].pixels, hall().images[i].pixels);
}

}  // namespace
}  // namespace host
