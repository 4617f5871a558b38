#include "mres/level/depth_pyramid.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "mres/gl/uniform_buffer.h"
#include "mres/level/frame_params.h"
#include "tests/support/gl_test.h"
#include "tests/support/glsl_function.h"
#include "tests/support/pictures.h"
#include "tests/support/synthetic_gbuffer.h"

namespace mres::test {
namespace {

std::vector<float> readMip(const gl::Texture2D& texture, int mip) {
  const glm::ivec2 size = glm::max(texture.size() >> mip, glm::ivec2(1));
  std::vector<float> texels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(GL_TEXTURE_2D, mip, GL_RED, GL_FLOAT, texels.data());
  return texels;
}

double viewDepth(const SyntheticGBuffer& gbuffer, glm::ivec2 pixel) {
  const Frame& frame = gbuffer.frame();
  const auto window =
      static_cast<double>(gbuffer.depths()[static_cast<std::size_t>(pixel.y * frame.size.x + pixel.x)]);
  const glm::dvec4 position =
      glm::inverse(glm::dmat4(frame.projection)) * glm::dvec4(0.0, 0.0, 2.0 * window - 1.0, 1.0);
  return -position.z / position.w;
}

class DepthPyramidTest : public GlTest {
 protected:
  void expectDepthsOfRealPixels(const SyntheticGBuffer& gbuffer) {
    const glm::ivec2 size = gbuffer.frame().size;
    PassContext context;
    DepthPyramid pyramid(shaderLibrary());
    gl::UniformBuffer<params::FrameParams> block;
    block.upload(frameParams(gbuffer.frame()));
    block.bind(kFrameBlock);
    gl::bindTexture(kDepthUnit, gbuffer.frame().depth, context.nearest);
    EXPECT_TRUE(pyramid.draw(context, gbuffer.frame()));
    ASSERT_EQ(pyramid.texture().levels(), depthPyramidLevels(size));
    for (int mip = 0; mip < pyramid.texture().levels(); ++mip) {
      const glm::ivec2 mipSize = glm::max(size >> mip, glm::ivec2(1));
      const std::vector<float> texels = readMip(pyramid.texture(), mip);
      for (int i = 0; i < mipSize.x * mipSize.y; ++i) {
        const glm::ivec2 texel(i % mipSize.x, i / mipSize.x);
        const glm::ivec2 pixel = glm::min(texel * (1 << mip) + (1 << mip) / 2, size - 1);
        const bool background =
            gbuffer.depths()[static_cast<std::size_t>(pixel.y * size.x + pixel.x)] == 1.0f;
        const double expected = background ? 1e18 : viewDepth(gbuffer, pixel);
        ASSERT_NEAR(static_cast<double>(texels[static_cast<std::size_t>(i)]) / expected, 1.0, 1e-4)
            << "mip " << mip << " of " << size.x << "x" << size.y << " at " << texel.x << ", " << texel.y;
      }
    }
  }
};

TEST_F(DepthPyramidTest, EveryTexelIsTheDepthOfOnePixelAtAKnownPlace) {
  for (const glm::ivec2 size : {glm::ivec2(1), glm::ivec2(1, 40), glm::ivec2(2, 3), glm::ivec2(31, 17),
                                glm::ivec2(127, 61), glm::ivec2(128, 64)}) {
    expectDepthsOfRealPixels(SyntheticGBuffer(size, perspective(size), room()));
  }
}

TEST_F(DepthPyramidTest, EveryDepthFormatAndOrthographicViews) {
  const glm::ivec2 size(45, 33);
  const glm::mat4 orthographic = glm::ortho(-3.0f, 3.0f, -1.4f, 2.0f, 0.1f, 20.0f);
  for (const GLenum format : {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F}) {
    expectDepthsOfRealPixels(SyntheticGBuffer(size, orthographic, room(), {.format = format}));
    expectDepthsOfRealPixels(SyntheticGBuffer(size, perspective(size), room(), {.format = format}));
  }
}

TEST_F(DepthPyramidTest, BackgroundIsBehindEverySurface) {
  const glm::ivec2 size(45, 33);
  expectDepthsOfRealPixels(SyntheticGBuffer(size, perspective(size), sphere({0.0, 0.0, -3.0}, 1.0)));
}

TEST(DepthPyramidLevels, HaveNoEmptyMip) {
  for (int size = 1; size < 600; ++size) {
    for (const glm::ivec2 screen : {glm::ivec2(size, 4096), glm::ivec2(4096, size), glm::ivec2(size)}) {
      const int levels = depthPyramidLevels(screen);
      ASSERT_GE(levels, 1);
      ASSERT_LE(levels, 6);
      ASSERT_GT(std::min(screen.x, screen.y) >> (levels - 1), 0) << size;
    }
  }
}

}  // namespace
}  // namespace mres::test
