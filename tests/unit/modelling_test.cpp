#include "host/scene/builtin/modelling.h"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "host/scene/builtin/profile.h"
#include "tests/unit/mesh_checks.h"

namespace host::modelling {
namespace {

using test::faultOf;
using test::leakOf;
using test::uvAreaRatio;
using test::volumeOf;
using test::worstTangentError;

constexpr double kPi = glm::pi<double>();

std::size_t triangles(const Mesh& mesh) {
  return mesh.indices.size() / 3;
}

void expectSolid(const Mesh& mesh, double volume, double tolerance) {
  EXPECT_EQ(faultOf(mesh), "");
  EXPECT_EQ(leakOf(mesh), "");
  EXPECT_NEAR(volumeOf(mesh), volume, tolerance);
}

const std::vector<glm::vec2> kLShape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};

TEST(Modelling, BoxIsClosedAndMappedInMetres) {
  Mesh mesh;
  addBox(mesh, {1, 2, 3}, {2, 4, 6});
  expectSolid(mesh, 6.0, 1e-4);
  EXPECT_EQ(triangles(mesh), 12U);
  EXPECT_NEAR(uvAreaRatio(mesh), 1.0, 1e-5);
  EXPECT_LT(worstTangentError(mesh), 1e-4);
}

TEST(Modelling, BevelledBoxLosesItsEdges) {
  Mesh mesh;
  addBox(mesh, {-1, -1, -1}, {1, 1, 1}, 0.1f);
  // Twelve prisms of 0.1 x 0.1 / 2 x 1.8, and eight corner cubes less a tetrahedron of a sixth, and half of
  // the rest.
  EXPECT_EQ(faultOf(mesh), "");
  EXPECT_EQ(leakOf(mesh), "");
  EXPECT_LT(worstTangentError(mesh), 0.51);  // chamfers bend by 45 degrees, corners by 60 at most
  EXPECT_EQ(triangles(mesh), 44U);
  EXPECT_NEAR(volumeOf(mesh), 8.0 - 12.0 * 0.005 * 1.8 - 8.0 * 0.001 * 5.0 / 6.0, 1e-4);
}

TEST(Modelling, QuadFacesItsCrossProduct) {
  Mesh mesh;
  addQuad(mesh, {0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {3, 4});
  EXPECT_EQ(faultOf(mesh), "");
  EXPECT_EQ(triangles(mesh), 24U);
  EXPECT_FLOAT_EQ(mesh.vertices[0].normal.z, 1.0f);
  EXPECT_FLOAT_EQ(mesh.vertices[0].uv.y, 2.0f);  // the lower-left corner is the image's lower-left corner
  EXPECT_NEAR(uvAreaRatio(mesh), 1.0, 1e-5);
  EXPECT_LT(worstTangentError(mesh), 1e-4);
}

TEST(Modelling, CylinderAndConeAreClosed) {
  Mesh cylinder;
  addCylinder(cylinder, {1, 2, 3}, 0.5f, 0.5f, 2.0f, 64);
  expectSolid(cylinder, kPi * 0.25 * 2.0, 0.01);
  EXPECT_EQ(triangles(cylinder), 4U * 64U);
  Mesh cone;
  addCylinder(cone, {0, 0, 0}, 0.5f, 0.0f, 3.0f, 64);
  expectSolid(cone, kPi * 0.25, 0.01);
}

TEST(Modelling, LatheIsClosedAndKeepsItsCreases) {
  const std::vector<glm::vec2> profile{{0, 0}, {1, 0}, {1, 1}, {0.5f, 1}, {0.5f, 2}, {0, 2}};
  Mesh mesh;
  addLathe(mesh, {0, 0, 0}, profile, 96);
  expectSolid(mesh, kPi * (1.0 + 0.25), 0.02);
  for (const Vertex& vertex : mesh.vertices) {  // all creases are right angles: no normal is slanted
    EXPECT_NEAR(std::max(std::abs(vertex.normal.y), glm::length(glm::vec2(vertex.normal.x, vertex.normal.z))),
                1.0f, 1e-5f);
  }
}

TEST(Modelling, LatheTubeHasTangentsAlongItsTexture) {
  Mesh mesh;
  addLathe(mesh, {0, 0, 0}, std::vector<glm::vec2>{{0.5f, 0}, {0.5f, 1}}, 64);
  EXPECT_LT(worstTangentError(mesh), 0.005);
  EXPECT_NEAR(uvAreaRatio(mesh), 1.0, 0.01);
}

TEST(Modelling, EllipsoidHasItsVolume) {
  Mesh mesh;
  addEllipsoid(mesh, {1, 1, 1}, {1, 2, 0.5f}, {64, 48});
  expectSolid(mesh, 4.0 / 3.0 * kPi, 0.02);
}

TEST(Modelling, ExtrusionOfAConcaveOutline) {
  Mesh mesh;
  addExtrusion(mesh, kLShape, 0.5f);
  expectSolid(mesh, 2.0, 1e-4);
  EXPECT_EQ(triangles(mesh), 2U * 4U + 2U * 6U);
  EXPECT_NEAR(uvAreaRatio(mesh), 1.0, 1e-4);
  EXPECT_LT(worstTangentError(mesh), 1e-4);
}

TEST(Modelling, SweepAlongALineIsAnExtrusion) {
  const std::array<glm::vec3, 2> path{{{0, 0, 0}, {0, 0, -3}}};
  Mesh mesh;
  addSweep(mesh, kLShape, path);
  expectSolid(mesh, 4.0 * 3.0, 1e-3);
  EXPECT_NEAR(uvAreaRatio(mesh), 1.0, 1e-4);
  EXPECT_LT(worstTangentError(mesh), 1e-4);
  for (const Vertex& vertex : mesh.vertices) {  // walking along -Z, x is right and y up
    EXPECT_GE(vertex.position.x, -1e-5f);
    EXPECT_GE(vertex.position.y, -1e-5f);
  }
}

TEST(Modelling, SweepMitresTheCornersOfAFrame) {
  const std::array<glm::vec3, 4> path{{{0, 0, 0}, {4, 0, 0}, {4, 0, -3}, {0, 0, -3}}};
  Mesh mesh;
  addSweep(mesh, rectangleOutline(0.2f, 0.1f), path, true);
  expectSolid(mesh, 0.02 * 14.0, 1e-4);  // Pappus: area times the length of the centre line
  EXPECT_EQ(triangles(mesh), 4U * 4U * 2U);
}

TEST(Modelling, SweepAroundACircleIsATorus) {
  std::vector<glm::vec3> path = arcPath({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, 0.0f, glm::two_pi<float>(), 96);
  path.pop_back();
  Mesh mesh;
  addSweep(mesh, circleOutline(0.2f, 24), path, true);
  expectSolid(mesh, 2.0 * kPi * kPi * 0.04, 0.02);
}

TEST(Modelling, SweepWithASharpTurnInSpaceStaysClosed) {
  const std::array<glm::vec3, 4> path{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}};
  Mesh mesh;
  addSweep(mesh, circleOutline(0.1f, 12), path);
  EXPECT_EQ(faultOf(mesh), "");
  EXPECT_EQ(leakOf(mesh), "");
  EXPECT_GT(volumeOf(mesh), 0.0);
}

TEST(Modelling, PatchFacesUAcrossVUp) {
  Mesh mesh;
  addPatch(mesh, [](float u, float v) { return glm::vec3(2 * u, v, 0.2f * u * u); }, {8, 8});
  EXPECT_EQ(faultOf(mesh), "");
  EXPECT_GT(mesh.vertices[0].normal.z, 0.9f);
  EXPECT_NEAR(uvAreaRatio(mesh), 1.0, 0.05);
}

TEST(Modelling, PatchWithACollapsedEdgeHasNormals) {
  Mesh mesh;
  addPatch(mesh, [](float u, float v) { return glm::vec3((u - 0.5f) * (1.0f - v), v, 0.0f); }, {4, 4});
  EXPECT_EQ(faultOf(mesh), "");
  EXPECT_EQ(triangles(mesh), 4U * 4U * 2U - 4U);
}

TEST(Modelling, TransformsKeepFacesOutward) {
  Mesh part;
  addBox(part, {0, 0, 0}, {1, 2, 3}, 0.05f);
  Mesh mesh;
  addBox(mesh, {-9, 0, 0}, {-8, 1, 1});
  addMesh(mesh, part, glm::scale(glm::mat4(1.0f), glm::vec3(-2.0f, 1.0f, 1.0f)));
  EXPECT_EQ(faultOf(mesh), "");
  EXPECT_EQ(leakOf(mesh), "");
  EXPECT_GT(volumeOf(mesh), 12.0);
}

TEST(Modelling, TurnedTexturesKeepTheirTangents) {
  Mesh mesh;
  addQuad(mesh, {0, 0, 0}, {3, 0, 0}, {0, 2, 0});
  turnTextureFrom(mesh, 0);
  EXPECT_LT(worstTangentError(mesh), 1e-4);
  EXPECT_NEAR(mesh.vertices[0].tangent.y, 1.0f, 1e-5f);
}

TEST(Modelling, TriangulationCoversAConcavePolygon) {
  const std::vector<glm::ivec3> cut = triangulate(kLShape);
  double area = 0.0;
  for (const glm::ivec3& t : cut) {
    const glm::vec2 a = kLShape[t.y] - kLShape[t.x];
    const glm::vec2 b = kLShape[t.z] - kLShape[t.x];
    area += 0.5 * (a.x * b.y - a.y * b.x);
  }
  EXPECT_EQ(cut.size(), 4U);
  EXPECT_NEAR(area, 4.0, 1e-5);
}

TEST(SceneBuilder, CollectsWhatItIsGiven) {
  SceneBuilder builder("test");
  const int texture = builder.addImage({"white", {1, 1}, {255, 255, 255, 255}});
  Material material;
  material.baseColorTexture = tiled(texture, 0.5f);
  Mesh mesh;
  mesh.material = builder.addMaterial(material);
  addBox(mesh, {0, 0, 0}, {1, 1, 1});
  const int index = builder.addMesh(mesh);
  builder.place(index);
  builder.place(index, glm::translate(glm::mat4(1.0f), {2, 0, 0}));
  const Scene scene = builder.take();
  EXPECT_EQ(scene.instances.size(), 2U);
  EXPECT_EQ(scene.materials[0].baseColorTexture.texture, 0);
  EXPECT_FLOAT_EQ(scene.materials[0].baseColorTexture.uvTransform[0][0], 2.0f);
}

}  // namespace
}  // namespace host::modelling
