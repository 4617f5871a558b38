#pragma once

#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <vector>

#include "host/platform/gl_context.h"
#include "mres/gl/texture.h"

namespace mres::test {

/// A test with an OpenGL context, shared by the whole process, that fails if the test leaves an OpenGL error.
class GlTest : public testing::Test {
 protected:
  static void SetUpTestSuite();
  void TearDown() override;
};

/// Level 0 of a texture as floats: `channels` per texel, rows bottom to top.
std::vector<float> readPixels(GLuint texture, glm::ivec2 size, int channels);

}  // namespace mres::test
