// Materials, textures and the tangents that normal maps need.
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gltf_test_file.h"
#include "host/image/image_file.h"
#include "host/scene/gltf/gltf_loader.h"

namespace {

using namespace gltf_test;
using testing::HasSubstr;

class GltfSurface : public testing::Test {
 protected:
  GltfSurface() {
    file_.addSquare()["material"] = 0;
    file_.json["textures"] = {{{"source", 0}}};
    file_.json["images"] = {{{"uri", "two%20words.png"}}};
    writePicture("two words.png");
  }

  void writePicture(const std::string& name) const {
    host::writeImage(folder_.path() / name, {{2, 1}, 4, {1.0f, 0.0f, 0.0f, 0.5f, 0.0f, 1.0f, 0.0f, 1.0f}});
  }

  void setMaterial(Json material) { file_.json["materials"] = {std::move(material)}; }
  [[nodiscard]] host::Material material() const { return file_.load(folder_).materials.at(0); }

  TemporaryFolder folder_;
  GltfFile file_;
};

TEST_F(GltfSurface, DefaultsAreThoseOfGltf) {
  setMaterial(Json::object());
  const host::Material result = material();
  EXPECT_EQ(result.baseColor, glm::vec4(1.0f));
  EXPECT_EQ(result.metallic, 1.0f);
  EXPECT_EQ(result.roughness, 1.0f);
  EXPECT_EQ(result.emissive, glm::vec3(0.0f));
  EXPECT_EQ(result.alphaMode, host::AlphaMode::opaque);
  EXPECT_EQ(result.alphaCutoff, 0.5f);
  EXPECT_FALSE(result.doubleSided);
}

TEST_F(GltfSurface, ImagesKeepStraightAlpha) {
  setMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  const host::Scene scene = file_.load(folder_);
  ASSERT_EQ(scene.images.size(), 1U);
  EXPECT_EQ(scene.images[0].size, glm::ivec2(2, 1));
  EXPECT_EQ(scene.images[0].pixels, (std::vector<std::uint8_t>{255, 0, 0, 128, 0, 255, 0, 255}));
}

TEST_F(GltfSurface, SamplersSetWrapAndFilter) {
  setMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  file_.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}};
  file_.json["textures"][0]["sampler"] = 0;
  const host::Texture texture = file_.load(folder_).textures.at(0);
  EXPECT_EQ(texture.wrapS, host::Wrap::clampToEdge);
  EXPECT_EQ(texture.wrapT, host::Wrap::mirroredRepeat);
  EXPECT_TRUE(texture.nearest);
}

TEST_F(GltfSurface, TextureTransformFollowsTheExtensionsExample) {
  const Json transform = {{"offset", {0, 1}}, {"rotation", glm::half_pi<float>()}, {"scale", {0.5, 0.5}}};
  setMaterial(
      {{"pbrMetallicRoughness",
        {{"baseColorTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}}}}}});
  // The lower left quadrant, rotated clockwise by 90 degrees: its upper left corner is seen at the upper
  // right.
  const glm::mat3 matrix = material().baseColorTexture.uvTransform;
  const auto transformed = [&matrix](float u, float v) { return glm::vec2(matrix * glm::vec3(u, v, 1.0f)); };
  EXPECT_LT(glm::distance(transformed(0, 0), glm::vec2(0.0f, 1.0f)), 1e-6f);
  EXPECT_LT(glm::distance(transformed(1, 0), glm::vec2(0.0f, 0.5f)), 1e-6f);
  EXPECT_LT(glm::distance(transformed(0, 1), glm::vec2(0.5f, 1.0f)), 1e-6f);
}

TEST_F(GltfSurface, MissingImageLeavesThePlainFactors) {
  setMaterial({{"pbrMetallicRoughness",
                {{"baseColorFactor", {0.5, 0.25, 1, 1}}, {"baseColorTexture", {{"index", 0}}}}}});
  file_.json["images"][0]["uri"] = "nowhere.png";
  const host::Scene scene = file_.load(folder_);
  EXPECT_EQ(scene.materials[0].baseColor, glm::vec4(0.5f, 0.25f, 1.0f, 1.0f));
  EXPECT_EQ(scene.materials[0].baseColorTexture.texture, -1);
  EXPECT_THAT(scene.warnings, testing::Contains(HasSubstr("nowhere.png")));
}

TEST_F(GltfSurface, LostTexturesNeitherGlowNorShine) {
  setMaterial({{"emissiveFactor", {1, 1, 1}},
               {"emissiveTexture", {{"index", 7}}},
               {"pbrMetallicRoughness", {{"metallicRoughnessTexture", {{"index", -2}}}}}});
  EXPECT_EQ(material().emissive, glm::vec3(0.0f));
  EXPECT_EQ(material().metallic, 0.0f);
}

TEST_F(GltfSurface, EmissiveStrengthMultiplies) {
  setMaterial({{"emissiveFactor", {1, 0.5, 0}},
               {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 10}}}}}});
  EXPECT_EQ(material().emissive, glm::vec3(10.0f, 5.0f, 0.0f));
}

TEST_F(GltfSurface, UnlitEmitsItsBaseColour) {
  setMaterial({{"pbrMetallicRoughness", {{"baseColorFactor", {0.2, 0.4, 0.6, 0.8}}}},
               {"extensions", {{"KHR_materials_unlit", Json::object()}}}});
  EXPECT_EQ(material().emissive, glm::vec3(0.2f, 0.4f, 0.6f));
  EXPECT_EQ(material().baseColor, glm::vec4(0.0f, 0.0f, 0.0f, 0.8f));
}

TEST_F(GltfSurface, SpecularGlossinessGivesItsDiffuseColour) {
  const Json extension = {{"diffuseFactor", {0.1, 0.2, 0.3, 1}}, {"glossinessFactor", 0.75}};
  setMaterial({{"extensions", {{"KHR_materials_pbrSpecularGlossiness", extension}}}});
  EXPECT_EQ(material().baseColor, glm::vec4(0.1f, 0.2f, 0.3f, 1.0f));
  EXPECT_EQ(material().roughness, 0.25f);
  EXPECT_EQ(material().metallic, 0.0f);
}

TEST_F(GltfSurface, AlphaModes) {
  setMaterial({{"alphaMode", "MASK"}, {"alphaCutoff", 0.25}, {"doubleSided", true}});
  EXPECT_EQ(material().alphaMode, host::AlphaMode::mask);
  EXPECT_EQ(material().alphaCutoff, 0.25f);
  EXPECT_TRUE(material().doubleSided);
  setMaterial({{"alphaMode", "BLEND"}});
  EXPECT_EQ(material().alphaMode, host::AlphaMode::blend);
}

TEST_F(GltfSurface, TheBaseColourChoosesTheTextureCoordinates) {
  const int second = file_.addAccessor(std::vector<float>(8, 0.75f), kFloat, "VEC2", 2);
  file_.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_1"] = second;
  setMaterial({{"normalTexture", {{"index", 0}}},
               {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 1}}}}}});
  const host::Scene scene = file_.load(folder_);
  EXPECT_EQ(scene.meshes[0].vertices[0].uv, glm::vec2(0.75f));
  EXPECT_EQ(scene.materials[0].normalTexture.texture, -1);
  EXPECT_THAT(scene.warnings, testing::Contains(HasSubstr("TEXCOORD_0")));
}

TEST_F(GltfSurface, TangentsFollowTheTextureCoordinates) {
  setMaterial({{"normalTexture", {{"index", 0}}}});
  const host::Mesh mesh = file_.load(folder_).meshes.at(0);
  for (const host::Vertex& vertex : mesh.vertices) {
    EXPECT_LT(glm::distance(vertex.tangent, glm::vec4(1, 0, 0, 1)), 1e-5f);
  }
}

TEST_F(GltfSurface, TangentsFollowTheTextureTransform) {
  const Json mirror = {{"KHR_texture_transform", {{"scale", {-1, 1}}}}};
  setMaterial({{"normalTexture", {{"index", 0}, {"extensions", mirror}}}});
  const host::Mesh mesh = file_.load(folder_).meshes.at(0);
  for (const host::Vertex& vertex : mesh.vertices) {
    EXPECT_LT(glm::distance(vertex.tangent, glm::vec4(-1, 0, 0, -1)), 1e-5f);
  }
}

TEST_F(GltfSurface, MirroredTextureCoordinatesSplitSharedVertices) {
  // Two squares side by side; u runs 0..1 over the left one and back over the right one.
  const int positions = file_.addPositions({-1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 1, 0, 0, 1, 0, 1, 1, 0});
  const int normals = file_.addAccessor(
      std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, kFloat, "VEC3", 3);
  const int uvs =
      file_.addAccessor(std::vector<float>{0, 1, 1, 1, 0, 1, 0, 0, 1, 0, 0, 0}, kFloat, "VEC2", 2);
  const int indices = file_.addAccessor(std::vector<std::uint8_t>{0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4},
                                        kUnsignedByte, "SCALAR", 1);
  file_.addPrimitive({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uvs}}},
                      {"indices", indices},
                      {"material", 0}});
  setMaterial({{"normalTexture", {{"index", 0}}}});
  const host::Mesh mesh = file_.load(folder_).meshes.at(1);
  EXPECT_EQ(mesh.vertices.size(), 8U);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const glm::vec4 expected = i < 6 ? glm::vec4(1, 0, 0, 1) : glm::vec4(-1, 0, 0, -1);
    EXPECT_LT(glm::distance(mesh.vertices[mesh.indices[i]].tangent, expected), 1e-5f) << i;
  }
}

}  // namespace
