#include "host/renderer/renderer.h"

#include <gmock/gmock.h>

#include "host/renderer/convex.h"
#include "host/renderer/frustum.h"
#include "tests/gpu/renderer_support.h"

namespace host::test {
namespace {

class RendererFacadeTest : public RendererTest {};

Scene smallScene() {
  Scene scene;
  place(scene, cube(), chalk());
  Material glass = chalk();
  glass.baseColor.a = 0.5f;
  glass.alphaMode = AlphaMode::blend;
  glass.doubleSided = true;
  place(scene, cube(), glass);
  scene.lights.push_back(sunAlong({0.3f, -1.0f, -0.5f}, 3.0f));
  return scene;
}

void drawAll(Renderer& renderer, glm::ivec2 size) {
  renderer.drawGeometry(frontCamera(6.0f), size);
  renderer.drawLighting({});
  renderer.drawToneMap();
}

TEST_F(RendererFacadeTest, DrawsEverySize) {
  Renderer renderer(smallScene(), profiler());
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(1, 257), glm::ivec2(509, 1), glm::ivec2(97, 61),
                                glm::ivec2(7680, 3), glm::ivec2(5, 4320), glm::ivec2(64, 48)}) {
    drawAll(renderer, size);
    const FloatImage picture = readTexture(renderer.drawToneMap(), size, 4);
    EXPECT_GT(centre(picture).g, 0.1f) << size.x << " x " << size.y;
  }
}

TEST_F(RendererFacadeTest, KeepsItsTargetsWhileTheSizeStays) {
  Renderer renderer(smallScene(), profiler());
  drawAll(renderer, kSize);
  const std::size_t bytes = renderer.gpuBytes();
  const GLuint depth = renderer.drawGeometry(frontCamera(), kSize).depth;
  const GLuint lit = renderer.drawLighting({});
  EXPECT_EQ(renderer.drawGeometry(frontCamera(4.0f), kSize).depth, depth);
  EXPECT_EQ(renderer.drawLighting({}), lit);
  EXPECT_EQ(renderer.gpuBytes(), bytes);
  drawAll(renderer, kSize * 2);
  EXPECT_GT(renderer.gpuBytes(), bytes);
  drawAll(renderer, kSize);
  EXPECT_EQ(renderer.gpuBytes(), bytes);
}

TEST_F(RendererFacadeTest, ThePictureOfAFrameDependsOnNothingBefore) {
  Renderer renderer(smallScene(), profiler());
  drawAll(renderer, kSize);
  const std::vector<float> first = readTexture(renderer.drawToneMap(), kSize, 4).pixels;
  renderer.drawGeometry(lookAt("", {3.0f, 4.0f, 5.0f}, glm::vec3(0.0f), 70.0f), {31, 17});
  renderer.drawLighting({});
  renderer.drawToneMap();
  drawAll(renderer, kSize);
  EXPECT_EQ(readTexture(renderer.drawToneMap(), kSize, 4).pixels, first);
}

TEST_F(RendererFacadeTest, GivesTheMatricesOfTheLastDraw) {
  Renderer renderer(smallScene(), profiler());
  const Camera camera = frontCamera(6.0f);
  renderer.drawGeometry(camera, kSize);
  EXPECT_EQ(renderer.view(), viewMatrix(camera));
  EXPECT_EQ(renderer.projection(), projectionMatrix(camera, 64.0f / 48.0f));
}

TEST_F(RendererFacadeTest, RefusesImpossibleSizesWithASentence) {
  Renderer renderer(smallScene(), profiler());
  for (const glm::ivec2 size : {glm::ivec2(0, 10), glm::ivec2(10, -1), glm::ivec2(1 << 20, 4)}) {
    EXPECT_THAT([&] { renderer.drawGeometry(frontCamera(), size); },
                testing::ThrowsMessage<std::runtime_error>(
                    testing::HasSubstr("cannot be drawn; this OpenGL device")));
  }
  for (const int texels : {1 << 20, 16, 0}) {
    EXPECT_THAT([&] { const Renderer odd(smallScene(), profiler(), {.shadowMapSize = texels}); },
                testing::ThrowsMessage<std::runtime_error>(
                    testing::HasSubstr("A shadow map of " + std::to_string(texels) + " texels")));
  }
}

TEST(FrustumTest, KeepsWhatMayBeSeenAndCullsWhatIsOutside) {
  const Camera camera = frontCamera(10.0f);
  const Frustum frustum(projectionMatrix(camera, 1.0f) * viewMatrix(camera));
  const auto box = [](glm::vec3 middle) { return Bounds{middle - 0.5f, middle + 0.5f}; };
  EXPECT_TRUE(frustum.mayIntersect(box(glm::vec3(0.0f))));
  EXPECT_TRUE(frustum.mayIntersect(box({0.0f, 0.0f, 10.0f})));  // around the camera
  EXPECT_TRUE(frustum.mayIntersect(box({4.0f, 0.0f, 0.0f})));   // reaches in from the side
  EXPECT_FALSE(frustum.mayIntersect(box({4.6f, 0.0f, 0.0f})));
  EXPECT_FALSE(frustum.mayIntersect(box({0.0f, 0.0f, 11.0f})));   // behind
  EXPECT_FALSE(frustum.mayIntersect(box({0.0f, 0.0f, -41.0f})));  // beyond
}

TEST(FrustumTest, TransformedBoundsEncloseTheTransformedCorners) {
  const Bounds box{{-1.0f, 0.0f, 2.0f}, {3.0f, 0.5f, 2.5f}};
  glm::mat4 transform(0.2f, -1.0f, 0.5f, 0.0f, 3.0f, 0.1f, -0.2f, 0.0f, 0.0f, 0.7f, -1.5f, 0.0f, 5.0f, -2.0f,
                      1.0f, 1.0f);
  const Bounds result = transformed(box, transform);
  Bounds expected{glm::vec3(1e9f), glm::vec3(-1e9f)};
  for (const glm::vec3& corner : cornersOf(box)) {
    const glm::vec3 point(transform * glm::vec4(corner, 1.0f));
    expected = {glm::min(expected.min, point), glm::max(expected.max, point)};
  }
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(result.min[axis], expected.min[axis], 1e-5f);
    EXPECT_NEAR(result.max[axis], expected.max[axis], 1e-5f);
  }
}

TEST(ConvexTest, IntersectionOfBoxesIsTheirCommonBox) {
  const Bounds a{glm::vec3(0.0f), glm::vec3(4.0f)};
  const Bounds b{{1.0f, -1.0f, 3.0f}, {2.0f, 2.0f, 9.0f}};
  const std::vector<glm::vec3> points =
      intersectionPoints(cornersOf(a), planesOf(a), cornersOf(b), planesOf(b));
  Bounds common{glm::vec3(1e9f), glm::vec3(-1e9f)};
  for (const glm::vec3& point : points) common = {glm::min(common.min, point), glm::max(common.max, point)};
  EXPECT_LT(glm::length(common.min - glm::vec3(1.0f, 0.0f, 3.0f)), 1e-5f);
  EXPECT_LT(glm::length(common.max - glm::vec3(2.0f, 2.0f, 4.0f)), 1e-5f);
  const Bounds apart{glm::vec3(5.0f), glm::vec3(6.0f)};
  EXPECT_TRUE(intersectionPoints(cornersOf(a), planesOf(a), cornersOf(apart), planesOf(apart)).empty());
}

}  // namespace
}  // namespace host::test
