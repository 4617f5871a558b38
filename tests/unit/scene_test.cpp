#include "host/scene/scene.h"

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gltf_test_file.h"
#include "host/scene/auto_cameras.h"
#include "host/scene/triangle_grid.h"

namespace {

using testing::HasSubstr;

glm::vec3 project(const host::Camera& camera, float aspect, glm::vec3 point) {
  const glm::vec4 clip =
      host::projectionMatrix(camera, aspect) * host::viewMatrix(camera) * glm::vec4(point, 1.0f);
  return glm::vec3(clip) / clip.w;
}

/// A box seen from outside, or from inside when `inwards`.
host::Scene boxScene(glm::vec3 size, bool inwards) {
  host::Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-0.5f, 0.5f}) {
      glm::vec3 centre(0.0f);
      glm::vec3 u(0.0f);
      glm::vec3 v(0.0f);
      centre[axis] = side;
      u[(axis + 1) % 3] = 0.5f;
      v[(axis + 2) % 3] = 0.5f;
      if ((side < 0.0f) != inwards) std::swap(u, v);
      const auto first = std::uint32_t(mesh.vertices.size());
      for (const glm::vec3 corner : {centre - u - v, centre + u - v, centre + u + v, centre - u + v}) {
        mesh.vertices.push_back({.position = corner * size});
      }
      mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }
  }
  host::Scene scene;
  scene.meshes.push_back(mesh);
  scene.instances.push_back({0, glm::mat4(1.0f)});
  return scene;
}

std::string loadError(const std::string& name) {
  try {
    host::loadScene(name);
    return {};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(Scene, CountsAndBoundsCoverInstances) {
  host::Scene scene = boxScene(glm::vec3(2.0f), false);
  glm::mat4 moved(1.0f);
  moved[3] = glm::vec4(10, 0, 0, 1);
  scene.instances.push_back({0, moved});
  EXPECT_EQ(host::triangleCount(scene), 24U);
  EXPECT_EQ(host::boundsOf(scene).min, glm::vec3(-1, -1, -1));
  EXPECT_EQ(host::boundsOf(scene).max, glm::vec3(11, 1, 1));
}

TEST(Scene, EmptyScenesHaveTheUnitCubesBounds) {
  EXPECT_EQ(host::boundsOf({}).min, glm::vec3(-0.5f));
  EXPECT_EQ(host::boundsOf({}).max, glm::vec3(0.5f));
}

TEST(Camera, LookAtPutsTheTargetIntoTheMiddle) {
  for (const glm::vec3 target : {glm::vec3(3, 1, -2), glm::vec3(0, -9, 0), glm::vec3(0, 9, 0)}) {
    const host::Camera camera = host::lookAt("test", {0, 1, 0}, target, 60.0f);
    const glm::vec3 projected = project(camera, 1.5f, target);
    EXPECT_NEAR(projected.x, 0.0f, 1e-5f);
    EXPECT_NEAR(projected.y, 0.0f, 1e-5f);
    EXPECT_GT(projected.z, -1.0f);
    EXPECT_LT(projected.z, 1.0f);
  }
}

TEST(Camera, LookAtKeepsUpUp) {
  const host::Camera camera = host::lookAt("test", {0, 0, 0}, {5, 1, 3}, 60.0f);
  EXPECT_GT(project(camera, 1.0f, {5, 2, 3}).y, 0.0f);
}

TEST(Camera, ProjectionsMapTheClipPlanesToMinusOneAndOne) {
  host::Camera camera;
  camera.nearPlane = 0.5f;
  camera.farPlane = 20.0f;
  EXPECT_NEAR(project(camera, 1.0f, {0, 0, -0.5f}).z, -1.0f, 1e-5f);
  EXPECT_NEAR(project(camera, 1.0f, {0, 0, -20}).z, 1.0f, 1e-5f);
  EXPECT_NEAR(project(camera, 2.0f, {0, 10 * std::tan(camera.verticalFov / 2), -10}).y, 1.0f, 1e-5f);
  camera.orthographicHeight = 4.0f;
  EXPECT_NEAR(project(camera, 2.0f, {4, 2, -0.5f}).x, 1.0f, 1e-5f);
  EXPECT_NEAR(project(camera, 2.0f, {4, 2, -0.5f}).y, 1.0f, 1e-5f);
  EXPECT_NEAR(project(camera, 2.0f, {4, 2, -0.5f}).z, -1.0f, 1e-5f);
}

TEST(Camera, InfiniteFarPlaneStaysBelowOne) {
  host::Camera camera;
  camera.farPlane = 0.0f;
  EXPECT_NEAR(project(camera, 1.0f, {0, 0, -camera.nearPlane}).z, -1.0f, 1e-5f);
  EXPECT_LE(project(camera, 1.0f, {0, 0, -1e6f}).z, 1.0f);
}

TEST(TriangleGrid, RaysHitWhatTheyShould) {
  const host::TriangleGrid grid(boxScene(glm::vec3(2, 4, 6), false));
  const auto front = grid.trace({0.1f, 0.2f, 10}, {0, 0, -1});
  ASSERT_TRUE(front);
  EXPECT_NEAR(front->distance, 7.0f, 1e-4f);
  EXPECT_EQ(front->normal, glm::vec3(0, 0, 1));
  EXPECT_FALSE(front->isBackFace);
  const auto inside = grid.trace({0.1f, 0.2f, 0}, {0, 1, 0});
  ASSERT_TRUE(inside);
  EXPECT_NEAR(inside->distance, 1.8f, 1e-4f);
  EXPECT_TRUE(inside->isBackFace);
  EXPECT_FALSE(grid.trace({5, 0, 10}, {0, 0, -1}));
  EXPECT_FALSE(grid.trace({0, 0, 10}, {0, 0, 1}));
}

/// In the middle of a picture is the front of a surface, between the clip planes.
void expectToLookAtASurface(const host::Camera& camera, const host::TriangleGrid& grid) {
  const auto hit = grid.trace(camera.position, camera.orientation * glm::vec3(0, 0, -1));
  ASSERT_TRUE(hit) << camera.name;
  EXPECT_FALSE(hit->isBackFace) << camera.name;
  EXPECT_GT(hit->distance, camera.nearPlane) << camera.name;
  EXPECT_LT(hit->distance, camera.farPlane) << camera.name;
}

/// Eight, of which each two are further apart than `distance` or turned away from each other.
void expectEightDifferent(const std::vector<host::Camera>& cameras, float distance) {
  EXPECT_EQ(cameras.size(), 8U);
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const bool elsewhere = glm::distance(cameras[i].position, cameras[j].position) > distance;
      const bool turned = std::abs(glm::dot(cameras[i].orientation, cameras[j].orientation)) < 0.97f;
      EXPECT_TRUE(elsewhere || turned) << i << " and " << j;
    }
  }
}

TEST(AutomaticCameras, StandInsideOfRoomsAndLookAtTheirWalls) {
  const host::Scene room = boxScene({6, 3, 8}, true);
  const host::TriangleGrid grid(room);
  const auto cameras = host::automaticCameras(room);
  ASSERT_EQ(cameras.size(), 8U);
  for (const host::Camera& camera : cameras) {
    EXPECT_TRUE(glm::all(glm::lessThan(glm::abs(camera.position), glm::vec3(3, 1.5f, 4)))) << camera.name;
    expectToLookAtASurface(camera, grid);
  }
}

TEST(AutomaticCameras, LookAtObjectsFromOutsideWhateverTheirSize) {
  for (const float size : {0.1f, 1.0f, 220.0f}) {
    const host::Scene scene = boxScene(glm::vec3(size), false);
    const host::TriangleGrid grid(scene);
    const auto cameras = host::automaticCameras(scene);
    ASSERT_EQ(cameras.size(), 8U);
    for (const host::Camera& camera : cameras) expectToLookAtASurface(camera, grid);
  }
}

TEST(AutomaticCameras, DifferFromEachOtherInsideOfRooms) {
  expectEightDifferent(host::automaticCameras(boxScene({6, 3, 8}, true)), 0.3f);
}

/// Of a point all views are of nothing: there it is enough that no two are the same.
TEST(AutomaticCameras, DifferFromEachOtherAroundObjectsAndFlatThingsAndPoints) {
  for (const glm::vec3 size :
       {glm::vec3(0.1f), glm::vec3(1.0f), glm::vec3(220.0f), glm::vec3(4.0f, 0.0f, 4.0f), glm::vec3(0.0f)}) {
    SCOPED_TRACE(testing::Message() << size.x << " x " << size.y << " x " << size.z);
    expectEightDifferent(host::automaticCameras(boxScene(size, false)), 0.03f * glm::length(size));
  }
}

TEST(AutomaticCameras, CopeWithFlatAndEmptyScenes) {
  EXPECT_FALSE(host::automaticCameras({}).empty());
  host::Scene point = boxScene(glm::vec3(0.0f), false);
  EXPECT_EQ(host::automaticCameras(point).size(), 8U);
  host::Scene plane = boxScene({4, 0, 4}, false);
  EXPECT_EQ(host::automaticCameras(plane).size(), 8U);
}

TEST(LoadScene, UnknownNamesListTheKnownOnes) {
  EXPECT_THAT(loadError("kitchen"),
              HasSubstr("there is no scene 'kitchen'; use one of office, hall, breakfast"));
}

TEST(LoadScene, MissingFilesAreNamed) {
  EXPECT_THAT(loadError("nowhere/scene.gltf"), HasSubstr("'nowhere/scene.gltf' does not exist"));
}

TEST(LoadScene, FilesWithoutTrianglesAreRefused) {
  const gltf_test::TemporaryFolder folder;
  folder.write("empty.gltf", R"({"asset": {"version": "2.0"}})");
  EXPECT_THAT(loadError((folder.path() / "empty.gltf").string()), HasSubstr("nothing to draw"));
}

TEST(LoadScene, FilesGetTheCamerasAndLightsTheyLack) {
  const gltf_test::TemporaryFolder folder;
  gltf_test::GltfFile file;
  file.addSquare();
  folder.write("square.glb", file.glb());
  const host::Scene scene = host::loadScene((folder.path() / "square.glb").string());
  EXPECT_EQ(scene.cameras.size(), 8U);
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_LT(scene.lights[0].direction.y, 0.0f);
}

class CameraFile : public testing::Test {
 protected:
  CameraFile() {
    gltf_test::GltfFile file;
    file.addSquare();
    folder_.write("square.glb", file.glb());
  }
  void writeCameras(std::string_view json) const { folder_.write("square.cameras.json", json); }
  [[nodiscard]] std::string path() const { return folder_ / "square.glb"; }

 private:
  gltf_test::TemporaryFolder folder_;
};

TEST_F(CameraFile, BesideASceneReplacesItsCameras) {
  writeCameras(R"([{"name": "front", "position": [0, 0, 4], "target": [0, 0, 0], "vertical_fov": 60},
                   {"position": [3, 0, 0], "target": [0, 0, 0]}])");
  const host::Scene scene = host::loadScene(path());
  ASSERT_EQ(scene.cameras.size(), 2U);
  const host::Camera& front = scene.cameras[0];
  EXPECT_EQ(front.name, "front");
  EXPECT_EQ(front.position, glm::vec3(0.0f, 0.0f, 4.0f));
  EXPECT_LT(glm::distance(front.orientation * glm::vec3(0.0f, 0.0f, -1.0f), glm::vec3(0.0f, 0.0f, -1.0f)),
            1e-6f);
  EXPECT_FLOAT_EQ(glm::degrees(front.verticalFov), 60.0f);
  EXPECT_LT(front.nearPlane, 4.0f);
  EXPECT_GT(front.farPlane, 4.0f);
  EXPECT_FLOAT_EQ(glm::degrees(scene.cameras[1].verticalFov), 50.0f);
}

TEST_F(CameraFile, ThatIsBrokenIsRefusedInASentence) {
  const std::pair<const char*, const char*> kBroken[] = {
      {"", "no JSON list"},
      {"[]", "no JSON list"},
      {R"({"position": [0, 0, 4]})", "no JSON list"},
      {"[1]", "camera 0 is no object"},
      {R"([{"position": [0, 0, 4]}])", "needs a 'target' of three numbers"},
      {R"([{"position": [0, 0, "4"], "target": [0, 0, 0]}])", "has a 'position' that is no number"},
      {R"([{"position": [0, 0, 1e300], "target": [0, 0, 0]}])", "has a 'position' that is no number"},
      {R"([{"position": [0, 0, 0], "target": [0, 0, 0]}])", "looks at where it stands"},
      {R"([{"position": [0, 0, 4], "target": [0, 0, 0], "vertical_fov": 180}])", "give 1 to 170 degrees"},
      {R"([{"name": 5, "position": [0, 0, 4], "target": [0, 0, 0]}])", "'name' that is no text"}};
  for (const auto& [json, message] : kBroken) {
    writeCameras(json);
    EXPECT_THAT(loadError(path()), testing::AllOf(HasSubstr("square.cameras.json"), HasSubstr(message)));
  }
}

}  // namespace
