// Scenes as files for other renderers: read back, they are the same.
#include "host/scene/gltf/gltf_writer.h"

#include <array>
#include <fstream>
#include <gtest/gtest.h>

#include "host/scene/gltf/gltf_loader.h"
#include "tests/support/temporary_folder.h"

namespace host::test {
namespace {

Scene readBack(const Scene& scene, std::initializer_list<int> cameras) {
  const TemporaryFolder folder;
  const std::string file = folder / "scene.glb";
  std::ofstream(file, std::ios::binary) << toGlb(scene, std::span(cameras.begin(), cameras.size()));
  return loadGltf(file);
}

void expectNear(glm::vec3 actual, glm::vec3 expected) {
  EXPECT_LT(glm::distance(actual, expected), 1e-4f);
}

void expectSameView(const Camera& actual, const Camera& expected) {
  EXPECT_EQ(actual.name, expected.name);
  expectNear(actual.position, expected.position);
  expectNear(actual.orientation * glm::vec3(0, 0, -1), expected.orientation * glm::vec3(0, 0, -1));
  expectNear(actual.orientation * glm::vec3(0, 1, 0), expected.orientation * glm::vec3(0, 1, 0));
  EXPECT_FLOAT_EQ(actual.nearPlane, expected.nearPlane);
  EXPECT_FLOAT_EQ(actual.farPlane, expected.farPlane);
  EXPECT_EQ(actual.orthographicHeight, expected.orthographicHeight);
}

/// A triangle with holes: its texture has one opaque and one clear pixel.
Scene sieve() {
  Scene scene;
  scene.images.push_back({"holes", {2, 1}, {255, 0, 0, 255, 0, 255, 0, 0}});
  scene.textures.push_back({0, Wrap::clampToEdge, Wrap::mirroredRepeat, true});
  Material material;
  material.name = "sieve";
  material.alphaMode = AlphaMode::mask;
  material.alphaCutoff = 0.25f;
  material.doubleSided = true;
  material.baseColorTexture = {0, glm::mat3(2, 0, 0, 0, 3, 0, 0.5f, 0, 1)};
  scene.materials.push_back(material);
  Mesh mesh;
  mesh.material = 0;
  mesh.vertices.resize(3);
  mesh.vertices[1].position = {1, 0, 0};
  mesh.vertices[2].position = {0, 0, -1};
  mesh.vertices[2].uv = {1, 1};
  mesh.indices = {0, 1, 2};
  scene.meshes.push_back(mesh);
  scene.instances.emplace_back();
  return scene;
}

TEST(GltfWriter, KeepsTheTrianglesAndTheCameraOfABuiltinScene) {
  const Scene scene = loadScene("office");
  const Scene read = readBack(scene, {3});
  EXPECT_EQ(triangleCount(read), triangleCount(scene));
  EXPECT_EQ(read.instances.size(), scene.instances.size());
  expectNear(boundsOf(read).min, boundsOf(scene).min);
  expectNear(boundsOf(read).max, boundsOf(scene).max);
  ASSERT_EQ(read.cameras.size(), 1U);
  expectSameView(read.cameras[0], scene.cameras[3]);
  EXPECT_FLOAT_EQ(read.cameras[0].verticalFov, scene.cameras[3].verticalFov);
  EXPECT_EQ(read.warnings, std::vector<std::string>());
}

TEST(GltfWriter, KeepsHoles) {
  const Scene scene = sieve();
  const Scene read = readBack(scene, {});
  ASSERT_EQ(read.materials.size(), 1U);
  EXPECT_EQ(read.materials[0].name, "sieve");
  EXPECT_EQ(read.materials[0].alphaMode, AlphaMode::mask);
  EXPECT_EQ(read.materials[0].alphaCutoff, 0.25f);
  EXPECT_TRUE(read.materials[0].doubleSided);
  const Texture& texture = read.textures.at(std::size_t(read.materials[0].baseColorTexture.texture));
  EXPECT_EQ(texture.wrapS, Wrap::clampToEdge);
  EXPECT_EQ(texture.wrapT, Wrap::mirroredRepeat);
  EXPECT_TRUE(texture.nearest);
  EXPECT_EQ(read.images.at(std::size_t(texture.image)).pixels, scene.images[0].pixels);
  EXPECT_EQ(read.meshes.at(0).vertices.at(2).uv, glm::vec2(2.5f, 3));
}

TEST(GltfWriter, KeepsUnusualCameras) {
  Scene scene = sieve();
  scene.cameras.push_back(lookAt("to infinity", {1, 2, 3}, {0, 0, 0}, 40));
  scene.cameras.back().farPlane = 0;
  scene.cameras.push_back(lookAt("plan", {0, 9, 0}, {0, 0, 0}, 40));
  scene.cameras.back().orthographicHeight = 5.0f;
  const Scene read = readBack(scene, {0, 1});
  ASSERT_EQ(read.cameras.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) expectSameView(read.cameras[i], scene.cameras[i]);
}

}  // namespace
}  // namespace host::test
