// Nodes, cameras and lights; and files that are broken as a whole.
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gltf_test_file.h"
#include "host/scene/gltf/gltf_loader.h"

namespace {

using namespace gltf_test;
using testing::Contains;
using testing::HasSubstr;

class GltfHierarchy : public testing::Test {
 protected:
  GltfHierarchy() { file_.addSquare(); }

  [[nodiscard]] host::Scene load() const { return file_.load(folder_); }
  [[nodiscard]] std::string loadError() const { return file_.loadError(folder_); }

  /// Where the square's corner (1, 1, 0) of the only instance is.
  [[nodiscard]] glm::vec3 corner() const {
    const host::Scene scene = load();
    EXPECT_EQ(scene.instances.size(), 1U);
    return {scene.instances.at(0).transform * glm::vec4(1, 1, 0, 1)};
  }

  TemporaryFolder folder_;
  GltfFile file_;
};

TEST_F(GltfHierarchy, TransformsMultiplyDownTheTree) {
  const float half = std::sqrt(0.5f);
  file_.json["nodes"] = {{{"children", {1}}, {"translation", {10, 0, 0}}, {"scale", {2, 2, 2}}},
                         {{"children", {2}}, {"rotation", {0, 0, half, half}}},
                         {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1}}}};
  // (1, 1, 0) moves to (6, 1, 0), turns to (-1, 6, 0), grows to (-2, 12, 0), moves to (8, 12, 0).
  EXPECT_LT(glm::distance(corner(), glm::vec3(8, 12, 0)), 1e-4f);
}

TEST_F(GltfHierarchy, MirroringIsKept) {
  file_.json["nodes"] = {{{"mesh", 0}, {"scale", {-1, 1, 1}}}};
  EXPECT_LT(glm::determinant(load().instances.at(0).transform), 0.0f);
}

TEST_F(GltfHierarchy, TheDefaultSceneIsShown) {
  file_.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {5, 0, 0}}}};
  file_.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
  file_.json["scene"] = 1;
  EXPECT_EQ(corner(), glm::vec3(6, 1, 0));
  file_.json.erase("scene");
  EXPECT_EQ(corner(), glm::vec3(1, 1, 0));
  file_.json["scene"] = 9;
  EXPECT_EQ(corner(), glm::vec3(1, 1, 0));
}

TEST_F(GltfHierarchy, CyclesAndSecondParentsAreCut) {
  file_.json["nodes"] = {{{"mesh", 0}, {"children", {1, 1}}}, {{"mesh", 0}, {"children", {0, 1}}}};
  file_.json["scenes"] = {{{"nodes", {0}}}};
  const host::Scene scene = load();
  EXPECT_EQ(scene.instances.size(), 2U);
  EXPECT_THAT(scene.warnings, Contains(HasSubstr("Node 0 has several parents")));
}

TEST_F(GltfHierarchy, VeryDeepTreesDoNotOverflowTheStack) {
  constexpr int kDepth = 200'000;
  Json nodes = Json::array();
  for (int i = 0; i + 1 < kDepth; ++i) nodes.push_back({{"children", {i + 1}}});
  nodes.push_back({{"mesh", 0}});
  file_.json["nodes"] = nodes;
  EXPECT_EQ(load().instances.size(), 1U);
}

TEST_F(GltfHierarchy, BrokenTransforms) {
  file_.json["nodes"] = {{{"mesh", 0}, {"scale", {1e30, 1, 1}}}, {{"mesh", 0}, {"scale", {0, 1, 1}}}};
  EXPECT_EQ(load().instances.size(), 0U);
  EXPECT_EQ(load().warnings.size(), 2U);
  file_.json["nodes"] = {{{"mesh", 0}, {"matrix", {1, 2, 3}}}};
  EXPECT_THAT(loadError(), HasSubstr("the matrix of node 0 has 3 numbers instead of 16"));
}

TEST_F(GltfHierarchy, UnresolvedReferencesAreErrors) {
  file_.json["nodes"] = {{{"mesh", 4}}};
  EXPECT_THAT(loadError(), HasSubstr("mesh 4, which does not exist"));
  file_.json["nodes"] = {{{"mesh", -7}}};
  EXPECT_THAT(loadError(), HasSubstr("mesh -7, which does not exist"));
  file_.json["nodes"] = {{{"children", {-3}}}};
  EXPECT_THAT(loadError(), HasSubstr("node -3, which does not exist"));
}

TEST_F(GltfHierarchy, CamerasLookAlongTheirNodesMinusZ) {
  const float half = std::sqrt(0.5f);
  file_.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}},
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 4}, {"ymag", 3}, {"znear", 0}, {"zfar", 50}}}}};
  file_.json["nodes"].push_back(
      {{"camera", 0}, {"translation", {1, 2, 3}}, {"rotation", {0, half, 0, half}}, {"scale", {3, 3, 3}}});
  file_.json["nodes"].push_back({{"camera", 1}});
  const host::Scene scene = load();
  ASSERT_EQ(scene.cameras.size(), 2U);
  EXPECT_EQ(scene.cameras[0].position, glm::vec3(1, 2, 3));
  EXPECT_LT(glm::distance(scene.cameras[0].orientation * glm::vec3(0, 0, -1), glm::vec3(-1, 0, 0)), 1e-5f);
  EXPECT_EQ(scene.cameras[0].farPlane, 0.0f);
  EXPECT_FALSE(scene.cameras[0].orthographicHeight);
  EXPECT_EQ(scene.cameras[1].orthographicHeight, 6.0f);
}

TEST_F(GltfHierarchy, ImpossibleClipPlanesAreMadeToFit) {
  file_.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 5}, {"zfar", 2}}}}};
  file_.json["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 4}}});
  const host::Camera camera = load().cameras.at(0);
  EXPECT_LT(camera.nearPlane, 4.0f);
  EXPECT_GT(camera.farPlane, 4.0f);
}

TEST_F(GltfHierarchy, Lights) {
  file_.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "directional"}, {"intensity", 3}},
      {{"type", "spot"}, {"range", 9}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.5}}}}};
  const auto light = [](int index) { return Json{{"KHR_lights_punctual", {{"light", index}}}}; };
  const float half = std::sqrt(0.5f);
  file_.json["nodes"].push_back({{"extensions", light(0)}, {"rotation", {-half, 0, 0, half}}});
  file_.json["nodes"].push_back({{"extensions", light(1)}, {"translation", {0, 5, 0}}});
  file_.json["nodes"].push_back({{"extensions", light(2)}});
  const host::Scene scene = load();
  ASSERT_EQ(scene.lights.size(), 2U);
  EXPECT_EQ(scene.lights[0].intensity, 3.0f);
  EXPECT_LT(glm::distance(scene.lights[0].direction, glm::vec3(0, -1, 0)), 1e-5f);
  EXPECT_EQ(scene.lights[1].position, glm::vec3(0, 5, 0));
  EXPECT_EQ(scene.lights[1].range, 9.0f);
  EXPECT_EQ(scene.lights[1].outerConeAngle, 0.5f);
  EXPECT_THAT(scene.warnings, Contains(HasSubstr("Light 2 is left out")));
}

TEST_F(GltfHierarchy, MissingAndShortBuffers) {
  file_.json["buffers"][0]["uri"] = "nowhere.bin";
  EXPECT_THAT(loadError(), HasSubstr("nowhere.bin' does not exist"));
  file_.json["buffers"][0]["uri"] = "scene.bin";
  file_.json["buffers"][0]["byteLength"] = 1'000'000;
  EXPECT_THAT(loadError(), HasSubstr("buffer 0 should have 1000000 bytes"));
  file_.json["buffers"][0]["uri"] = "/dev/zero";
  EXPECT_THAT(loadError(), HasSubstr("is not a file"));
}

TEST_F(GltfHierarchy, WhatItCannotHonourIsNamed) {
  file_.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  EXPECT_THAT(loadError(), HasSubstr("it needs the extension KHR_draco_mesh_compression"));
  file_.json["extensionsRequired"] = {"KHR_materials_clearcoat"};
  EXPECT_THAT(loadError(), "");
  file_.json["asset"]["version"] = "1.0";
  EXPECT_THAT(loadError(), HasSubstr("its version is '1.0'"));
}

TEST_F(GltfHierarchy, NestingThatWouldOverflowTheStackIsRefused) {
  const std::size_t depth = 100'000;
  folder_.write("deep.gltf", R"({"asset":{"version":"2.0"},"extras":)" + std::string(depth, '[') +
                                 std::string(depth, ']') + "}");
  EXPECT_THROW(host::loadGltf(folder_.path() / "deep.gltf"), std::runtime_error);
}

}  // namespace
