#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>

#include "tests/gpu/renderer_support.h"

namespace host::test {
namespace {

/// Half a step of ten bits, and a little for the interpolation.
constexpr float kNormalTolerance = 2.0f / 1023.0f;

void expectNear(glm::vec3 actual, glm::vec3 expected, float tolerance) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
  EXPECT_NEAR(actual.z, expected.z, tolerance);
}

class GBufferTest : public RendererTest {};

/// Window depth of the plane through `point` with `normal` at each pixel, in double precision.
struct AnalyticPlane {
  glm::dvec3 point;
  glm::dvec3 normal;

  [[nodiscard]] double windowDepth(const Camera& camera, glm::ivec2 size, glm::ivec2 at) const {
    const double aspect = static_cast<double>(size.x) / size.y;
    const glm::dvec2 ndc = (glm::dvec2(at) + 0.5) / glm::dvec2(size) * 2.0 - 1.0;
    const glm::dvec2 screen(ndc.x * aspect, -ndc.y);  // rows run down
    const glm::dmat3 toWorld(glm::mat3_cast(glm::dquat(camera.orientation)));
    glm::dvec3 origin(camera.position);
    glm::dvec3 direction(0.0, 0.0, -1.0);
    if (camera.orthographicHeight) {
      origin += toWorld * glm::dvec3(screen * (*camera.orthographicHeight * 0.5), 0.0);
    } else {
      direction = glm::dvec3(screen * std::tan(camera.verticalFov * 0.5), -1.0);
    }
    const double distance = glm::dot(point - origin, normal) / glm::dot(toWorld * direction, normal);
    return clipDepth(camera, distance) * 0.5 + 0.5;
  }

  static double clipDepth(const Camera& camera, double distance) {
    const double n = camera.nearPlane;
    const double f = camera.farPlane;
    if (camera.orthographicHeight) return (2.0 * distance - n - f) / (f - n);
    if (f == 0.0) return 1.0 - 2.0 * n / distance;
    return (f + n) / (f - n) - 2.0 * f * n / ((f - n) * distance);
  }
};

Camera obliqueCamera() {
  Camera camera = lookAt("oblique", {1.0f, 2.0f, 3.0f}, {0.2f, 0.1f, -0.3f}, 55.0f);
  camera.nearPlane = 0.05f;
  camera.farPlane = 80.0f;
  return camera;
}

TEST_F(GBufferTest, DepthOfATiltedPlaneIsTheAnalyticOne) {
  const glm::mat4 tilt =
      glm::rotate(glm::mat4(1.0f), glm::radians(-75.0f), glm::normalize(glm::vec3(1.0f, 0.2f, 0.1f)));
  Scene scene = darkScene();
  place(scene, square(), chalk(), tilt * glm::scale(glm::mat4(1.0f), glm::vec3(30.0f)));
  const AnalyticPlane plane{glm::dvec3(0.0), glm::normalize(glm::dmat3(tilt) * glm::dvec3(0.0, 0.0, 1.0))};

  Camera infinite = obliqueCamera();
  infinite.farPlane = 0.0f;
  Camera orthographic = obliqueCamera();
  orthographic.orthographicHeight = 2.5f;
  for (const Camera& camera : {obliqueCamera(), infinite, orthographic}) {
    const FloatImage depth = drawGBuffer(scene, camera).depth;
    for (const glm::ivec2 at :
         {glm::ivec2(0, 0), glm::ivec2(63, 0), glm::ivec2(20, 31), glm::ivec2(0, 47), glm::ivec2(63, 47)}) {
      const double expected = plane.windowDepth(camera, kSize, at);
      ASSERT_GT(expected, 0.0);
      ASSERT_LT(expected, 1.0);
      EXPECT_NEAR(pixel(depth, at).x, expected, 2e-6) << at.x << ", " << at.y;
    }
  }
}

TEST_F(GBufferTest, NothingIsFarAndEmpty) {
  Scene scene = darkScene();
  place(scene, square(), chalk());
  const GBuffer gbuffer = drawGBuffer(scene, frontCamera());
  const glm::ivec2 corner(0);
  EXPECT_EQ(pixel(gbuffer.depth, corner).x, 1.0f);
  EXPECT_EQ(pixel(gbuffer.albedo, corner), glm::vec4(0.0f));
  expectNear(unpackNormal(pixel(gbuffer.normal, corner)), glm::vec3(0.0f), kNormalTolerance);
  EXPECT_EQ(pixel(gbuffer.emissive, corner), glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
  EXPECT_EQ(pixel(gbuffer.albedo, kSize / 2).a, 1.0f);
}

TEST_F(GBufferTest, AnEmptySceneIsNothing) {
  const GBuffer gbuffer = drawGBuffer(darkScene(), frontCamera());
  EXPECT_THAT(gbuffer.depth.pixels, testing::Each(1.0f));
}

TEST_F(GBufferTest, MaterialValuesArrive) {
  Scene scene = darkScene();
  Material material;
  material.baseColor = {0.2f, 0.5f, 0.8f, 1.0f};
  material.roughness = 0.4f;
  material.metallic = 0.7f;
  material.emissive = {0.5f, 2.0f, 100.0f};
  place(scene, square(), material);
  const GBuffer gbuffer = drawGBuffer(scene, frontCamera());
  const FloatImage encoded = encodeSrgb({glm::ivec2(1), 3, {0.2f, 0.5f, 0.8f}});
  expectNear(centre(gbuffer.albedo), pixel(encoded, glm::ivec2(0)), 1.0f / 255.0f);
  EXPECT_NEAR(centre(gbuffer.material).x, 0.4f, 1.0f / 255.0f);
  EXPECT_NEAR(centre(gbuffer.material).y, 0.7f, 1.0f / 255.0f);
  expectNear(centre(gbuffer.emissive) / glm::vec4(0.5f, 2.0f, 100.0f, 1.0f), glm::vec3(1.0f), 0.02f);
}

TEST_F(GBufferTest, BaseColorTexturesAreDecodedUprightAndMultiplied) {
  Scene scene = darkScene();
  Material material = chalk();
  material.baseColor = {0.5f, 0.5f, 0.5f, 1.0f};
  material.baseColorTexture.texture =
      addTexture(scene, {2, 2}, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 188, 188, 188, 255});
  place(scene, square(), material);
  const FloatImage albedo = drawGBuffer(scene, frontCamera()).albedo;
  const float half = 188.0f / 255.0f;  // sRGB code of 0.5
  expectNear(pixel(albedo, {26, 18}), {half, 0.0f, 0.0f}, 1.0f / 255.0f);
  expectNear(pixel(albedo, {38, 18}), {0.0f, half, 0.0f}, 1.0f / 255.0f);
  expectNear(pixel(albedo, {26, 30}), {0.0f, 0.0f, half}, 1.0f / 255.0f);
  const float quarter = 137.0f / 255.0f;  // sRGB code of 0.25
  expectNear(pixel(albedo, {38, 30}), glm::vec3(quarter), 1.5f / 255.0f);
}

TEST_F(GBufferTest, NormalsFollowRotationAndNonUniformScale) {
  Scene scene = darkScene();
  const glm::mat4 rotation = glm::rotate(glm::mat4(1.0f), 0.6f, glm::vec3(0.0f, 1.0f, 0.0f));
  place(scene, square(), chalk(), glm::scale(glm::mat4(1.0f), glm::vec3(1.0f, 1.0f, 3.0f)) * rotation);
  const glm::vec3 turned = glm::mat3(rotation) * glm::vec3(0.0f, 0.0f, 1.0f);
  const glm::vec3 expected = glm::normalize(turned / glm::vec3(1.0f, 1.0f, 3.0f));
  const GBuffer gbuffer = drawGBuffer(scene, frontCamera());
  expectNear(unpackNormal(centre(gbuffer.normal)), expected, kNormalTolerance);
  expectNear(unpackNormal(centre(gbuffer.geometricNormal)), expected, kNormalTolerance);
}

TEST_F(GBufferTest, MirroredInstancesShowTheSameSideWithTheRightNormals) {
  const glm::mat4 mirror = glm::scale(glm::mat4(1.0f), glm::vec3(-1.0f, 1.0f, 1.0f));
  const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), 0.5f, glm::vec3(0.0f, 1.0f, 0.0f));
  Scene scene = darkScene();
  place(scene, cube(), chalk(), mirror * turn);
  const GBuffer gbuffer = drawGBuffer(scene, frontCamera(6.0f));
  const glm::vec3 expected = glm::mat3(mirror * turn) * glm::vec3(0.0f, 0.0f, 1.0f);
  expectNear(unpackNormal(centre(gbuffer.normal)), expected, kNormalTolerance);
  const AnalyticPlane front{glm::dvec3(expected), glm::dvec3(expected)};
  EXPECT_NEAR(centre(gbuffer.depth).x, front.windowDepth(frontCamera(6.0f), kSize, kSize / 2), 2e-6);
}

TEST_F(GBufferTest, BackFacesShowOnlyWhereDoubleSidedAndFaceTheViewer) {
  const glm::mat4 away = glm::rotate(glm::mat4(1.0f), 2.8f, glm::vec3(0.0f, 1.0f, 0.0f));
  for (const bool mirrored : {false, true}) {
    const glm::mat4 transform = mirrored ? glm::scale(away, glm::vec3(-1.0f, 1.0f, 1.0f)) : away;
    for (const bool doubleSided : {false, true}) {
      Scene scene = darkScene();
      Material material = chalk();
      material.doubleSided = doubleSided;
      place(scene, square(), material, transform);
      const GBuffer gbuffer = drawGBuffer(scene, frontCamera());
      EXPECT_EQ(centre(gbuffer.depth).x < 1.0f, doubleSided);
      if (!doubleSided) continue;
      const glm::vec3 expected = glm::mat3(away) * glm::vec3(0.0f, 0.0f, -1.0f);
      expectNear(unpackNormal(centre(gbuffer.normal)), expected, kNormalTolerance);
    }
  }
}

TEST_F(GBufferTest, AlphaMaskLeavesHoles) {
  Scene scene = darkScene();
  Material material = chalk();
  material.alphaMode = AlphaMode::mask;
  material.alphaCutoff = 0.5f;
  material.baseColorTexture.texture = addTexture(scene, {2, 1}, {255, 255, 255, 120, 255, 255, 255, 140});
  place(scene, square(), material);
  place(scene, square(), chalk(), glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, -2.0f)));
  const FloatImage depth = drawGBuffer(scene, frontCamera()).depth;
  const auto depthOf = [](double distance) {
    return AnalyticPlane::clipDepth(frontCamera(), distance) * 0.5 + 0.5;
  };
  EXPECT_NEAR(pixel(depth, {28, 24}).x, depthOf(5.0), 2e-6);
  EXPECT_NEAR(pixel(depth, {36, 24}).x, depthOf(3.0), 2e-6);
}

TEST_F(GBufferTest, BlendedSurfacesAreNotInIt) {
  Scene scene = darkScene();
  Material glass = chalk();
  glass.alphaMode = AlphaMode::blend;
  place(scene, square(), glass);
  EXPECT_THAT(drawGBuffer(scene, frontCamera()).depth.pixels, testing::Each(1.0f));
}

TEST_F(GBufferTest, NormalMapsTurnTheShadingNormalAlone) {
  // Tangent space (0.6, 0, 0.8): towards the texture's right; then (0, 0.6, 0.8): towards its top.
  const std::vector<std::uint8_t> right = {204, 128, 230, 255};
  const std::vector<std::uint8_t> up = {128, 204, 230, 255};
  for (const bool mirrored : {false, true}) {
    for (const auto& [texel, expected] : {std::pair(right, glm::vec3(mirrored ? -0.6f : 0.6f, 0.0f, 0.8f)),
                                          std::pair(up, glm::vec3(0.0f, 0.6f, 0.8f))}) {
      Scene scene = darkScene();
      Material material = chalk();
      material.normalTexture.texture = addTexture(scene, {1, 1}, texel);
      place(scene, square(), material,
            glm::scale(glm::mat4(1.0f), glm::vec3(mirrored ? -1.0f : 1.0f, 1.0f, 1.0f)));
      const GBuffer gbuffer = drawGBuffer(scene, frontCamera());
      expectNear(unpackNormal(centre(gbuffer.normal)), expected, 0.01f);
      expectNear(unpackNormal(centre(gbuffer.geometricNormal)), {0.0f, 0.0f, 1.0f}, kNormalTolerance);
    }
  }
}

TEST_F(GBufferTest, MissingNormalsAndTangentsAreReplacedByTheTrianglesOwn) {
  Scene scene = darkScene();
  Mesh bare = square();
  for (Vertex& vertex : bare.vertices) {
    vertex.normal = glm::vec3(0.0f);
    vertex.tangent = glm::vec4(0.0f);
  }
  const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), 0.7f, glm::vec3(1.0f, 0.0f, 0.0f));
  place(scene, bare, chalk(), turn);
  const GBuffer gbuffer = drawGBuffer(scene, frontCamera());
  const glm::vec3 expected = glm::mat3(turn) * glm::vec3(0.0f, 0.0f, 1.0f);
  expectNear(unpackNormal(centre(gbuffer.normal)), expected, 2.0f * kNormalTolerance);
}

TEST_F(GBufferTest, FarFromTheOriginThePictureStaysTheSame) {
  const glm::vec3 far(65536.0f, 8192.0f, -32768.0f);  // floats there are 1/128 m apart
  const auto draw = [&](glm::vec3 offset) {
    Scene scene = darkScene();
    place(scene, cube(), chalk(), glm::translate(glm::mat4(1.0f), offset));
    Camera camera = lookAt("", glm::vec3(2.0f, 3.0f, 5.0f), glm::vec3(0.0f), 50.0f);
    camera.position += offset;
    return drawGBuffer(scene, camera);
  };
  const GBuffer near = draw(glm::vec3(0.0f));
  const GBuffer away = draw(far);
  EXPECT_EQ(near.depth.pixels, away.depth.pixels);
  EXPECT_EQ(near.normal.pixels, away.normal.pixels);
}

TEST_F(GBufferTest, InstancesOfOneMeshAreDrawnWhereTheyAre) {
  Scene scene = darkScene();
  place(scene, square(), chalk());
  scene.instances.clear();
  for (const float x : {-0.6f, 0.0f, 0.6f, 40.0f}) {  // the last one is out of sight
    scene.instances.push_back(
        {0, glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(x, 0.0f, 0.0f)), glm::vec3(0.2f))});
  }
  const FloatImage depth = drawGBuffer(scene, frontCamera()).depth;
  std::vector<bool> covered;
  for (const int x : {18, 25, 32, 39, 45}) covered.push_back(pixel(depth, {x, 24}).x < 1.0f);
  EXPECT_THAT(covered, testing::ElementsAre(true, false, true, false, true));
}

}  // namespace
}  // namespace host::test
