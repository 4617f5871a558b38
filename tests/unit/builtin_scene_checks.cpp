#include "tests/unit/builtin_scene_checks.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <set>

#include "tests/unit/mesh_checks.h"

namespace host::test {

namespace {

bool refersTo(int index, std::size_t count) {
  return index >= 0 && static_cast<std::size_t>(index) < count;
}

void expectTexture(const Scene& scene, const TextureUse& use, const std::string& material) {
  EXPECT_TRUE(use.texture == -1 || refersTo(use.texture, scene.textures.size())) << material;
}

float distanceToNearestVertex(const Scene& scene, glm::vec3 place) {
  float nearest = std::numeric_limits<float>::max();
  for (const Instance& instance : scene.instances) {
    for (const Vertex& vertex : scene.meshes[static_cast<std::size_t>(instance.mesh)].vertices) {
      const glm::vec3 world(instance.transform * glm::vec4(vertex.position, 1.0f));
      nearest = std::min(nearest, glm::distance(world, place));
    }
  }
  return nearest;
}

bool sameVertex(const Vertex& a, const Vertex& b) {
  return a.position == b.position && a.normal == b.normal && a.tangent == b.tangent && a.uv == b.uv;
}

}  // namespace

void expectSound(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes) {
    EXPECT_EQ(faultOf(mesh), "") << mesh.name;
    EXPECT_TRUE(refersTo(mesh.material, scene.materials.size())) << mesh.name;
  }
  for (const Instance& instance : scene.instances) EXPECT_TRUE(refersTo(instance.mesh, scene.meshes.size()));
  for (const Texture& texture : scene.textures) EXPECT_TRUE(refersTo(texture.image, scene.images.size()));
  for (const Material& material : scene.materials) {
    for (const TextureUse& use : {material.baseColorTexture, material.metallicRoughnessTexture,
                                  material.normalTexture, material.emissiveTexture}) {
      expectTexture(scene, use, material.name);
    }
  }
}

void expectEightCameras(const Scene& scene) {
  constexpr float kClearance = 0.1f;  // metres
  const Bounds bounds = boundsOf(scene);
  std::set<std::string> names;
  for (const Camera& camera : scene.cameras) {
    names.insert(camera.name);
    EXPECT_TRUE(glm::all(glm::greaterThan(camera.position, bounds.min))) << camera.name;
    EXPECT_TRUE(glm::all(glm::lessThan(camera.position, bounds.max))) << camera.name;
    EXPECT_GE(glm::degrees(camera.verticalFov), 39.9f) << camera.name;
    EXPECT_LE(glm::degrees(camera.verticalFov), 65.1f) << camera.name;
    EXPECT_GT(distanceToNearestVertex(scene, camera.position), kClearance) << camera.name;
    const auto sameView = std::count_if(scene.cameras.begin(), scene.cameras.end(), [&](const Camera& other) {
      return other.position == camera.position && other.orientation == camera.orientation;
    });
    EXPECT_EQ(sameView, 1) << camera.name;
  }
  EXPECT_EQ(scene.cameras.size(), 8U);
  EXPECT_EQ(names.size(), 8U);
}

void expectSame(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.meshes.size(), b.meshes.size());
  for (std::size_t i = 0; i < a.meshes.size(); ++i) {
    EXPECT_EQ(a.meshes[i].indices, b.meshes[i].indices) << a.meshes[i].name;
    EXPECT_TRUE(std::equal(a.meshes[i].vertices.begin(), a.meshes[i].vertices.end(),
                           b.meshes[i].vertices.begin(), b.meshes[i].vertices.end(), sameVertex))
        << a.meshes[i].name;
  }
  ASSERT_EQ(a.instances.size(), b.instances.size());
  for (std::size_t i = 0; i < a.instances.size(); ++i)
    EXPECT_EQ(a.instances[i].transform, b.instances[i].transform);
  ASSERT_EQ(a.images.size(), b.images.size());
  for (std::size_t i = 0; i < a.images.size(); ++i)
    EXPECT_EQ(a.images[i].pixels, b.images[i].pixels) << a.images[i].name;
}

}  // namespace host::test
