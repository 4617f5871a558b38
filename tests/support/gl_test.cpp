#include "tests/support/gl_test.h"

#include <memory>

namespace mres::test {

void GlTest::SetUpTestSuite() {
  static const auto kContext = std::make_unique<host::GlContext>();
}

void GlTest::TearDown() {
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

std::vector<float> readPixels(GLuint texture, glm::ivec2 size, int channels) {
  constexpr GLenum kFormats[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
  std::vector<float> pixels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                            static_cast<std::size_t>(channels));
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(GL_TEXTURE_2D, 0, kFormats[channels - 1], GL_FLOAT, pixels.data());
  return pixels;
}

}  // namespace mres::test
