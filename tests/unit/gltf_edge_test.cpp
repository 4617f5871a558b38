// Every odd and broken file of shared/scenes/edge, and the real scenes beside it.
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>

#include "gltf_test_file.h"
#include "host/scene/gltf/gltf_loader.h"

namespace {

using gltf_test::readTable;
using gltf_test::scenesFolder;

/// Files in which the Khronos validator sees no error, and why we refuse them all the same.
const std::map<std::string, std::string> kRefused = {
    {"asset_generator/Positive/Compatibility/Compatibility_04.gltf", "minVersion 2.1"},
    {"asset_generator/Positive/Compatibility/Compatibility_05.gltf", "requires a made-up extension"},
    {"gltf_pipeline/box-shared-image-references/box-shared-image-references.gltf",
     "requires KHR_techniques_webgl"},
    {"validator_corpus/base/asset/min_version_valid.gltf", "minVersion 2.1"},
    {"validator_corpus/base/accessor/unknown_type.gltf", "an accessor of unknown type"},
    {"validator_corpus/base/mesh/valid.gltf", "tinygltf wants indices to have a buffer view"},
    {"validator_corpus/base/root/named_objects.gltf", "a mesh whose buffer has no data"},
    {"validator_corpus/base/root/unused_objects.gltf", "a mesh whose buffer has no data"},
};

/// Valid files from which we draw other numbers of triangles: primitives without positions cannot be drawn.
const std::set<std::string> kWithoutPositions = {
    "asset_generator/Negative/Mesh_NoPosition/Mesh_NoPosition_00.gltf",
    "asset_generator/Negative/Mesh_NoPosition/Mesh_NoPosition_01.gltf",
};

/// Each mesh once, as the validator counts.
std::size_t uniqueTriangles(const host::Scene& scene) {
  std::size_t indices = 0;
  for (const host::Mesh& mesh : scene.meshes) indices += mesh.indices.size();
  return indices / 3;
}

bool isUnit(glm::vec3 vector) {
  return std::abs(glm::length(vector) - 1.0f) < 1e-3f;
}

/// All that the renderer relies on.
void expectSane(const host::Scene& scene) {
  for (const host::Mesh& mesh : scene.meshes) {
    ASSERT_EQ(mesh.indices.size() % 3, 0U);
    ASSERT_LT(mesh.material, int(scene.materials.size()));
    for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size());
    for (const host::Vertex& vertex : mesh.vertices) {
      ASSERT_TRUE(std::isfinite(glm::dot(vertex.position, vertex.position)));
      ASSERT_TRUE(std::isfinite(glm::dot(vertex.uv, vertex.uv)));
      ASSERT_TRUE(isUnit(vertex.normal));
      ASSERT_TRUE(isUnit(glm::vec3(vertex.tangent)));
      ASSERT_EQ(std::abs(vertex.tangent.w), 1.0f);
    }
  }
  for (const host::Instance& instance : scene.instances)
    ASSERT_LT(std::size_t(instance.mesh), scene.meshes.size());
  for (const host::Texture& texture : scene.textures)
    ASSERT_LT(std::size_t(texture.image), scene.images.size());
  for (const host::Material& material : scene.materials) {
    for (const host::TextureUse* use : {&material.baseColorTexture, &material.metallicRoughnessTexture,
                                        &material.normalTexture, &material.emissiveTexture}) {
      ASSERT_LT(use->texture, int(scene.textures.size()));
    }
  }
  for (const host::Image& image : scene.images) {
    ASSERT_EQ(image.pixels.size(), std::size_t(image.size.x) * std::size_t(image.size.y) * 4);
  }
  for (const host::Camera& camera : scene.cameras) {
    ASSERT_NEAR(glm::length(camera.orientation), 1.0f, 1e-3f);
    ASSERT_TRUE(camera.farPlane == 0.0f || camera.farPlane > camera.nearPlane);
  }
  const host::Bounds bounds = host::boundsOf(scene);
  ASSERT_TRUE(std::isfinite(glm::distance(bounds.min, bounds.max)));
}

/// "can't load '...': what is wrong; what to do", without line breaks.
void expectOneSentence(const std::string& message) {
  EXPECT_THAT(message, testing::StartsWith("can't load '"));
  EXPECT_THAT(message, testing::HasSubstr("; "));
  EXPECT_THAT(message, testing::Not(testing::HasSubstr("\n")));
}

/// As users get it, with the cameras and lights that a picture needs; what has nothing to draw, as it is.
host::Scene load(const std::filesystem::path& path) {
  try {
    host::Scene scene = host::loadScene(path.string());
    EXPECT_FALSE(scene.cameras.empty());
    EXPECT_FALSE(scene.lights.empty());
    return scene;
  } catch (const std::runtime_error& error) {
    if (std::string(error.what()).find("has nothing to draw") == std::string::npos) throw;
    return host::loadGltf(path);
  }
}

void checkEdgeFile(const std::string& file, bool isValid, const std::string& triangles,
                   const std::set<std::string>& unplaced) {
  SCOPED_TRACE(file);
  try {
    const host::Scene scene = load(scenesFolder() / "edge" / file);
    expectSane(scene);
    if (!isValid || kWithoutPositions.contains(file) || unplaced.contains(file)) return;
    EXPECT_EQ(std::to_string(uniqueTriangles(scene)), triangles);
    EXPECT_FALSE(kRefused.contains(file));
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    expectOneSentence(message);
    const bool isCompressed = message.find("_compression, which is not supported") != std::string::npos;
    EXPECT_TRUE(!isValid || isCompressed || kRefused.contains(file)) << message;
  }
}

/// Files of the validator whose meshes no node uses: a library of parts, of which nothing is drawn.
std::set<std::string> unplacedMeshes() {
  const std::string base = "validator_corpus/base/";
  const std::string ext = "validator_corpus/ext/";
  return {base + "json/integer_written_as_float.gltf",
          base + "mesh/custom_property.gltf",
          base + "mesh/primitive_generated_tangent_space.gltf",
          base + "mesh/primitive_incompatible_mode.gltf",
          base + "mesh/primitive_no_position.gltf",
          base + "mesh_data/index_buffer_degenerate_triangle.gltf",
          ext + "KHR_materials_clearcoat/data/material/valid_with_tangent.gltf",
          ext + "KHR_materials_variants/data/primitive/custom_property.gltf",
          ext + "KHR_materials_variants/data/primitive/valid.gltf",
          ext + "KHR_mesh_quantization/data/primitive/valid.gltf"};
}

TEST(GltfEdge, EveryFileLoadsSoundlyOrFailsWithOneSentence) {
  const auto rows = readTable("edge/EXPECTED.tsv");
  if (rows.empty()) GTEST_SKIP() << "set MRES_SCENES to the folder with the test scenes";
  const std::set<std::string> unplaced = unplacedMeshes();
  for (const auto& row : rows) checkEdgeFile(row.at(0), row.at(1) == "0", row.at(3), unplaced);
}

TEST(GltfScenes, HaveTheTrianglesOfTheManifest) {
  const auto rows = readTable("MANIFEST.tsv");
  if (rows.empty()) GTEST_SKIP() << "set MRES_SCENES to the folder with the test scenes";
  for (const auto& row : rows) {
    SCOPED_TRACE(row.at(1));
    const host::Scene scene = host::loadGltf(scenesFolder() / row.at(0) / row.at(1));
    EXPECT_EQ(std::to_string(host::triangleCount(scene)), row.at(2));
    EXPECT_EQ(std::to_string(scene.materials.size()), row.at(4));
    EXPECT_EQ(std::to_string(scene.cameras.size()), row.at(10));
    expectSane(scene);
  }
}

TEST(GltfScenes, DecodeEveryKindOfImage) {
  const auto file = scenesFolder() / "edge/made_here/image_formats/image_formats.gltf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "set MRES_SCENES to the folder with the test scenes";
  testing::internal::CaptureStderr();
  const host::Scene scene = host::loadGltf(file);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "warnings tell it";
  EXPECT_EQ(scene.images.size(), 11U);  // of thirteen, one is cut short and one is no image
  EXPECT_THAT(scene.warnings, testing::Contains(testing::HasSubstr("truncated.png")));
  EXPECT_THAT(scene.warnings, testing::Contains(testing::HasSubstr("not_an_image.png")));
}

}  // namespace
