// Frames that cannot be rendered are refused in a sentence, before anything is touched.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <string>
#include <vector>

#include "effects/soft_shadows/soft_shadows.h"
#include "effects/ssgi/ssgi.h"
#include "mres/level/frame_params.h"
#include "mres/mres.h"
#include "tests/support/gl_test.h"
#include "tests/support/pictures.h"
#include "tests/support/sentences.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

const glm::mat4 kGood = glm::perspective(1.0f, 1.0f, 0.1f, 10.0f);

Frame cameraFrame(const glm::mat4& projection) {
  return {.depth = 1, .normals = 1, .size = {64, 64}, .projection = projection};
}

void expectRefused(const Frame& frame, const std::string& part) {
  EXPECT_THAT([&] { static_cast<void>(frameParams(frame)); }, refusesInASentence(part));
}

TEST(FrameValidation, NamesAndSizes) {
  EXPECT_NO_THROW(static_cast<void>(frameParams(cameraFrame(kGood))));
  Frame bad = cameraFrame(kGood);
  bad.depth = 0;
  expectRefused(bad, "Frame::depth");
  bad = cameraFrame(kGood);
  bad.normals = 0;
  expectRefused(bad, "Frame::normals");
  for (const glm::ivec2 size : {glm::ivec2(0, 64), glm::ivec2(64, 16385), glm::ivec2(-5, 64)}) {
    bad = cameraFrame(kGood);
    bad.size = size;
    expectRefused(bad, "Frame::size");
  }
}

TEST(FrameValidation, MatricesThatAreNoCameras) {
  glm::mat4 bad = kGood;
  bad[1][1] = NAN;
  expectRefused(cameraFrame(bad), "finite");
  Frame frame = cameraFrame(kGood);
  frame.view[3][0] = INFINITY;
  expectRefused(frame, "finite");
  bad = kGood;
  bad[0][0] = 0.0f;
  expectRefused(cameraFrame(bad), "perspective or orthographic");
  expectRefused(cameraFrame(glm::mat4(0.0f)), "perspective or orthographic");
  for (const auto& [column, row] : {std::pair(0, 1), std::pair(1, 0), std::pair(0, 3), std::pair(1, 3)}) {
    bad = kGood;
    bad[column][row] = 0.2f;
    expectRefused(cameraFrame(bad), "perspective or orthographic");
  }
  bad = glm::ortho(-1.0f, 1.0f, -1.0f, 1.0f, 0.1f, 10.0f);
  bad[3][3] = -1.0f;
  expectRefused(cameraFrame(bad), "perspective or orthographic");
}

TEST(FrameValidation, LeftHandedCameras) {
  expectRefused(cameraFrame(glm::perspectiveLH_NO(1.0f, 1.0f, 0.1f, 10.0f)), "right-handed");
  expectRefused(cameraFrame(glm::orthoLH_NO(-1.0f, 1.0f, -1.0f, 1.0f, 0.1f, 10.0f)), "right-handed");
}

TEST(FrameValidation, ObliqueNearPlanes) {
  for (const int column : {0, 1}) {
    glm::mat4 oblique = kGood;
    oblique[column][2] = 0.1f;
    expectRefused(cameraFrame(oblique), "oblique near plane");
  }
}

TEST(FrameValidation, CamerasWithoutDepth) {
  glm::mat4 flat = kGood;
  flat[2][2] = -1.0f;
  flat[3][2] = 0.0f;
  expectRefused(cameraFrame(flat), "different depths");
  flat = glm::ortho(-1.0f, 1.0f, -1.0f, 1.0f, 0.1f, 10.0f);
  flat[2][2] = 0.0f;
  expectRefused(cameraFrame(flat), "different depths");
}

TEST(FrameValidation, RoundingAndJitterAreNoReasons) {
  const glm::mat4 jitter = glm::translate(glm::mat4(1.0f), {0.001f, -0.002f, 0.0f});
  EXPECT_NO_THROW(static_cast<void>(frameParams(cameraFrame(jitter * kGood))));
  EXPECT_NO_THROW(static_cast<void>(frameParams(cameraFrame(glm::inverse(glm::inverse(jitter * kGood))))));
}

class FrameTextures : public GlTest {
 protected:
  FrameTextures() : gbuffer_(kSize, perspective(kSize), room()) {}

  void expectTexturesRefused(const Frame& frame, const std::string& part) {
    EXPECT_THAT([&] { multiResolution_.render(effect_, frame); }, refusesInASentence(part));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << part;
    EXPECT_NO_THROW(multiResolution_.render(effect_, gbuffer_.frame())) << part;
  }

  static constexpr glm::ivec2 kSize{40, 30};
  SyntheticGBuffer gbuffer_;
  MultiResolution multiResolution_;
  TestEffect effect_{{.body = "return vec4(surface.depth);"}};
};

TEST_F(FrameTextures, MustBeTexturesOfTwoDimensions) {
  GLuint reserved = 0;
  glGenTextures(1, &reserved);
  const gl::TextureName cube = gl::TextureName::create();
  glBindTexture(GL_TEXTURE_CUBE_MAP, cube.id());
  glBindTexture(GL_TEXTURE_CUBE_MAP, 0);
  constexpr GLuint kNeverMade = 123456;
  for (const GLuint name : {reserved, cube.id(), kNeverMade}) {
    Frame bad = gbuffer_.frame();
    bad.depth = name;
    expectTexturesRefused(bad, "Frame::depth must name a GL_TEXTURE_2D");
    bad = gbuffer_.frame();
    bad.normals = name;
    expectTexturesRefused(bad, "Frame::normals must name a GL_TEXTURE_2D");
    bad = gbuffer_.frame();
    bad.importance = name;
    expectTexturesRefused(bad, "Frame::importance must name a GL_TEXTURE_2D");
  }
  EXPECT_EQ(glIsTexture(reserved), GL_FALSE) << "refusing a name must not make a texture of it";
  glDeleteTextures(1, &reserved);
}

TEST_F(FrameTextures, MustHaveTheSizeOfTheFrame) {
  const glm::ivec2 otherSize(41, 30);
  const SyntheticGBuffer other(otherSize, perspective(otherSize), room());
  Frame bad = gbuffer_.frame();
  bad.depth = other.frame().depth;
  expectTexturesRefused(bad, "Frame::depth has 41x30 texels, but Frame::size is 40x30.");
  bad = gbuffer_.frame();
  bad.normals = other.frame().normals;
  expectTexturesRefused(bad, "Frame::normals has 41x30 texels");
}

TEST_F(FrameTextures, MustHaveFormatsThatShadersCanRead) {
  const gl::Texture2D color(GL_R32F, kSize, "test.color");
  Frame bad = gbuffer_.frame();
  bad.depth = color.id();
  expectTexturesRefused(bad, "Frame::depth must have a depth format");
  bad = gbuffer_.frame();
  bad.normals = color.id();
  expectTexturesRefused(bad, "at least 3 channels");
  const gl::TextureName integers = gl::TextureName::create();
  glBindTexture(GL_TEXTURE_2D, integers.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8UI, kSize.x, kSize.y, 0, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE, nullptr);
  glBindTexture(GL_TEXTURE_2D, 0);
  bad.normals = integers.id();
  expectTexturesRefused(bad, "integer");
  for (const GLuint name : {integers.id(), gbuffer_.frame().depth}) {
    bad = gbuffer_.frame();
    bad.importance = name;
    expectTexturesRefused(bad, "Frame::importance must have at least 1 channel");
  }
}

TEST_F(FrameTextures, OfEffectsAreCheckedToo) {
  const gl::Texture2D color(GL_RGBA16F, kSize, "test.color");
  const gl::Texture2D grey(GL_R16F, kSize, "test.grey");
  const glm::ivec2 otherSize(41, 30);
  const gl::Texture2D wide(GL_RGBA16F, otherSize, "test.wide");
  const auto refusal = [&](Effect& effect) -> std::string {
    try {
      multiResolution_.render(effect, gbuffer_.frame());
      return "";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  SoftShadows shadows({.samples = 1});
  const GLuint depth = gbuffer_.frame().depth;
  shadows.setInputs({.shadowMap = 123456, .mapSize = kSize});
  EXPECT_THAT(refusal(shadows), testing::HasSubstr("ShadowInputs::shadowMap must name a GL_TEXTURE_2D"));
  shadows.setInputs({.shadowMap = depth, .mapSize = otherSize});
  EXPECT_THAT(refusal(shadows), testing::HasSubstr("ShadowInputs::mapSize is 41x30"));
  shadows.setInputs({.shadowMap = color.id(), .mapSize = kSize});
  EXPECT_THAT(refusal(shadows), testing::HasSubstr("must have a depth format"));
  shadows.setInputs({.shadowMap = depth, .mapSize = kSize});
  EXPECT_EQ(refusal(shadows), "");
  Ssgi ssgi({.samples = 8});
  ssgi.setInputs({.radiance = wide.id()});
  EXPECT_THAT(refusal(ssgi), testing::HasSubstr("SsgiInputs::radiance has 41x30 texels"));
  ssgi.setInputs({.radiance = grey.id()});
  EXPECT_THAT(refusal(ssgi), testing::HasSubstr("at least 3 channels"));
  ssgi.setInputs({.radiance = color.id()});
  EXPECT_EQ(refusal(ssgi), "");
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(FrameTextures, MayBeTheFirstUsedMipOfATexture) {
  const Picture expected = renderPicture(multiResolution_, effect_, gbuffer_.frame());
  const gl::TextureName mipped = gl::TextureName::create();
  glBindTexture(GL_TEXTURE_2D, mipped.id());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, 80, 60, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  glTexImage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT32F, 40, 30, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
               gbuffer_.depths().data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1);
  glBindTexture(GL_TEXTURE_2D, 0);
  Frame frame = gbuffer_.frame();
  frame.depth = mipped.id();
  EXPECT_EQ(renderPicture(multiResolution_, effect_, frame), expected);
}

}  // namespace
}  // namespace mres::test
