#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "gltf_test_file.h"
#include "host/scene/gltf/gltf_loader.h"

namespace {

using namespace gltf_test;
using testing::HasSubstr;

class GltfGeometry : public testing::Test {
 protected:
  [[nodiscard]] host::Mesh onlyMesh() const {
    const host::Scene scene = file_.load(folder_);
    EXPECT_EQ(scene.meshes.size(), 1U);
    return scene.meshes.at(0);
  }

  /// The positions of the triangles' corners, in order.
  static std::vector<glm::vec3> corners(const host::Mesh& mesh) {
    std::vector<glm::vec3> positions;
    for (const std::uint32_t index : mesh.indices) positions.push_back(mesh.vertices.at(index).position);
    return positions;
  }

  static glm::vec3 faceNormal(const host::Mesh& mesh, std::size_t triangle) {
    const auto p = corners(mesh);
    return glm::normalize(
        glm::cross(p[3 * triangle + 1] - p[3 * triangle], p[3 * triangle + 2] - p[3 * triangle]));
  }

  TemporaryFolder folder_;
  GltfFile file_;
};

TEST_F(GltfGeometry, SquareWithIndices) {
  file_.addSquare();
  const host::Mesh mesh = onlyMesh();
  EXPECT_EQ(corners(mesh),
            (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
}

TEST_F(GltfGeometry, GlbHoldsTheSame) {
  file_.addSquare();
  folder_.write("scene.glb", file_.glb());
  const host::Scene scene = host::loadGltf(folder_.path() / "scene.glb");
  EXPECT_EQ(host::triangleCount(scene), 2U);
}

TEST_F(GltfGeometry, GlbIsKnownByItsContentNotItsName) {
  file_.addSquare();
  folder_.write("scene.gltf", file_.glb());
  EXPECT_EQ(host::triangleCount(host::loadGltf(folder_.path() / "scene.gltf")), 2U);
}

TEST_F(GltfGeometry, TrianglesWithoutIndices) {
  file_.addPrimitive({{"attributes", {{"POSITION", file_.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}});
  EXPECT_EQ(corners(onlyMesh()), (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST_F(GltfGeometry, StripsWindAlike) {
  const int positions = file_.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
  file_.addPrimitive({{"attributes", {{"POSITION", positions}}}, {"mode", 5}});
  const host::Mesh mesh = onlyMesh();
  ASSERT_EQ(mesh.indices.size(), 9U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(faceNormal(mesh, i), glm::vec3(0, 0, 1)) << i;
}

TEST_F(GltfGeometry, FansWindAlike) {
  const int positions = file_.addPositions({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, -1, 1, 0});
  file_.addPrimitive({{"attributes", {{"POSITION", positions}}}, {"mode", 6}});
  const host::Mesh mesh = onlyMesh();
  ASSERT_EQ(mesh.indices.size(), 9U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(faceNormal(mesh, i), glm::vec3(0, 0, 1)) << i;
}

TEST_F(GltfGeometry, PointsAndLinesAreLeftOut) {
  const int positions = file_.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  for (const int mode : {0, 1, 2, 3})
    file_.addPrimitive({{"attributes", {{"POSITION", positions}}}, {"mode", mode}});
  const host::Scene scene = file_.load(folder_);
  EXPECT_EQ(host::triangleCount(scene), 0U);
  EXPECT_EQ(scene.warnings.size(), 4U);
}

TEST_F(GltfGeometry, EveryIndexType) {
  const int positions = file_.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int narrow = file_.addAccessor(std::vector<std::uint8_t>{0, 1, 2}, kUnsignedByte, "SCALAR", 1);
  const int wide = file_.addAccessor(std::vector<std::uint32_t>{0, 1, 2}, kUnsignedInt, "SCALAR", 1);
  for (const int indices : {narrow, wide}) {
    file_.addPrimitive({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  }
  EXPECT_EQ(host::triangleCount(file_.load(folder_)), 2U);
}

TEST_F(GltfGeometry, InterleavedAttributes) {
  const std::vector<float> vertices = {0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1};
  const int view = file_.addView(vertices, 24);
  const auto accessor = [&](int offset) {
    return file_.addAccessor({{"bufferView", view},
                              {"byteOffset", offset},
                              {"componentType", kFloat},
                              {"count", 3},
                              {"type", "VEC3"}});
  };
  const int positions = accessor(0);
  const int normals = accessor(12);
  file_.addPrimitive({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}});
  const host::Mesh mesh = onlyMesh();
  EXPECT_EQ(corners(mesh)[1], glm::vec3(1, 0, 0));
  for (const host::Vertex& vertex : mesh.vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
}

TEST_F(GltfGeometry, SparseAccessorReplacesElements) {
  const int positions = file_.addPositions({0, 0, 0, 1, 0, 0, 9, 9, 9});
  const int indices = file_.addView(std::vector<std::uint16_t>{2});
  const int values = file_.addView(std::vector<float>{0, 1, 0});
  file_.json["accessors"][positions]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", indices}, {"componentType", kUnsignedShort}}},
      {"values", {{"bufferView", values}}}};
  file_.addPrimitive({{"attributes", {{"POSITION", positions}}}});
  EXPECT_EQ(corners(onlyMesh()), (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST_F(GltfGeometry, SparseAccessorWithoutAViewStartsFromZeros) {
  const int indices = file_.addView(std::vector<std::uint8_t>{1, 2});
  const int values = file_.addView(std::vector<float>{1, 0, 0, 0, 1, 0});
  const int positions =
      file_.addAccessor({{"componentType", kFloat},
                         {"count", 3},
                         {"type", "VEC3"},
                         {"sparse",
                          {{"count", 2},
                           {"indices", {{"bufferView", indices}, {"componentType", kUnsignedByte}}},
                           {"values", {{"bufferView", values}}}}}});
  file_.addPrimitive({{"attributes", {{"POSITION", positions}}}});
  EXPECT_EQ(corners(onlyMesh()), (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST_F(GltfGeometry, QuantizedAttributes) {
  const int positions =
      file_.addAccessor(std::vector<std::int16_t>{0, 0, 0, 100, 0, 0, 0, -100, 0}, kShort, "VEC3", 3);
  const int normals =
      file_.addAccessor(std::vector<std::int8_t>{0, 0, -127, 0, 0, -127, 0, 0, -128}, kByte, "VEC3", 3);
  const int uvs =
      file_.addAccessor(std::vector<std::uint16_t>{0, 0, 65535, 0, 0, 65535}, kUnsignedShort, "VEC2", 2);
  file_.json["accessors"][normals]["normalized"] = true;
  file_.json["accessors"][uvs]["normalized"] = true;
  file_.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  file_.addPrimitive({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uvs}}}});
  const host::Mesh mesh = onlyMesh();
  EXPECT_EQ(corners(mesh)[2], glm::vec3(0, -100, 0));
  for (const host::Vertex& vertex : mesh.vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 0, -1));
  EXPECT_EQ(mesh.vertices[1].uv, glm::vec2(1, 0));
}

TEST_F(GltfGeometry, MissingNormalsAreFlat) {
  const int positions = file_.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  const int indices =
      file_.addAccessor(std::vector<std::uint8_t>{0, 1, 2, 0, 3, 1}, kUnsignedByte, "SCALAR", 1);
  file_.addPrimitive({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  const host::Mesh mesh = onlyMesh();
  EXPECT_EQ(mesh.vertices.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(mesh.vertices[mesh.indices[i]].normal, faceNormal(mesh, i / 3)) << i;
  }
}

TEST_F(GltfGeometry, ZeroAndInfiniteNormalsAreRepaired) {
  const float inf = std::numeric_limits<float>::infinity();
  const int positions = file_.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int normals = file_.addAccessor(std::vector<float>{0, 0, 0, inf, 0, 0, 0, 3, 0}, kFloat, "VEC3", 3);
  file_.addPrimitive({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}});
  const host::Mesh mesh = onlyMesh();
  EXPECT_EQ(mesh.vertices[0].normal, glm::vec3(0, 0, 1));
  EXPECT_EQ(mesh.vertices[1].normal, glm::vec3(0, 0, 1));
  EXPECT_EQ(mesh.vertices[2].normal, glm::vec3(0, 1, 0));
}

TEST_F(GltfGeometry, TrianglesWithNanAreDropped) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const int positions = file_.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0, nan, 0, 0, 1, 0, 0, 0, 1, 0});
  file_.addPrimitive({{"attributes", {{"POSITION", positions}}}});
  const host::Scene scene = file_.load(folder_);
  EXPECT_EQ(host::triangleCount(scene), 1U);
  EXPECT_THAT(scene.warnings, testing::Contains(HasSubstr("not finite")));
}

TEST_F(GltfGeometry, OnlyUsedVerticesAreKept) {
  std::vector<float> many(3000, 5.0f);
  const int positions = file_.addPositions(many);
  const int indices =
      file_.addAccessor(std::vector<std::uint16_t>{997, 998, 999}, kUnsignedShort, "SCALAR", 1);
  const int normals = file_.addAccessor(std::vector<float>(3000, 1.0f), kFloat, "VEC3", 3);
  file_.addPrimitive({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}, {"indices", indices}});
  EXPECT_EQ(onlyMesh().vertices.size(), 3U);
}

TEST_F(GltfGeometry, IndexOutOfRangeIsAnError) {
  const int positions = file_.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int indices = file_.addAccessor(std::vector<std::uint16_t>{0, 1, 3}, kUnsignedShort, "SCALAR", 1);
  file_.addPrimitive({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  EXPECT_THAT(file_.loadError(folder_),
              HasSubstr("index 2 of primitive 0 of mesh 0 '' is 3, but there are 3 vertices"));
}

TEST_F(GltfGeometry, RangesThatOverflowAreErrors) {
  const int positions = file_.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  file_.addPrimitive({{"attributes", {{"POSITION", positions}}}});
  const std::uint64_t huge = std::numeric_limits<std::int64_t>::max();
  const Json original = file_.json;
  for (const std::uint64_t count : {std::uint64_t(4), std::uint64_t(1) << 61U, huge}) {
    file_.json["accessors"][positions]["count"] = count;
    EXPECT_THAT(file_.loadError(folder_), HasSubstr("too short for its")) << count;
  }
  file_.json = original;
  for (const std::uint64_t offset : {std::uint64_t(1), std::uint64_t(36), huge}) {
    file_.json["accessors"][positions]["byteOffset"] = offset;
    EXPECT_THAT(file_.loadError(folder_), HasSubstr("too short for its")) << offset;
  }
  file_.json = original;
  for (const std::uint64_t offset : {std::uint64_t(1), huge}) {
    file_.json["bufferViews"][0]["byteOffset"] = offset;
    EXPECT_THAT(file_.loadError(folder_), HasSubstr("reaches past the end of buffer 0")) << offset;
  }
}

TEST_F(GltfGeometry, CountsThatNoDataBacksAreErrors) {
  const int positions =
      file_.addAccessor({{"componentType", kFloat}, {"count", std::uint64_t(1) << 40U}, {"type", "VEC3"}});
  file_.addPrimitive({{"attributes", {{"POSITION", positions}}}});
  EXPECT_THAT(file_.loadError(folder_), HasSubstr("have no data"));
  file_.json["accessors"][positions]["count"] = 1U << 24U;
  EXPECT_THAT(file_.loadError(folder_), HasSubstr("more triangles than"));
}

}  // namespace
