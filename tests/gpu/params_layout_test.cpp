// The *_params.h headers are read by C++ and by GLSL: both must put every member at the same place.
#include <cstddef>

#include "shaders/effects/ssao_params.h"
#include "shaders/mres/edges_params.h"
#include "shaders/mres/frame_params.h"
#include "shaders/mres/level_params.h"
#include "shaders/mres/mask_blur_params.h"
#include "tests/support/gl_test.h"
#include "tests/support/glsl_function.h"

namespace mres::test {
namespace {

struct Member {
  std::string name;
  std::size_t offset;
};

struct Block {
  std::string header;
  std::string name;
  std::size_t size;
  std::string use;  // an expression of one member, so that the block stays
  std::vector<Member> members;
};

#define MEMBER(Struct, name) \
  { #name, offsetof(params::Struct, name) }
#define ARRAY_MEMBER(Struct, name) \
  { #name "[0]", offsetof(params::Struct, name) }

std::vector<Block> allBlocks() {
  return {{"mres/frame_params.h",
           "FrameParams",
           sizeof(params::FrameParams),
           "linearise.x",
           {MEMBER(FrameParams, viewFromNormals), MEMBER(FrameParams, pixelX), MEMBER(FrameParams, pixelY),
            MEMBER(FrameParams, clipW), MEMBER(FrameParams, unprojectScaled),
            MEMBER(FrameParams, unprojectConstant), MEMBER(FrameParams, linearise),
            MEMBER(FrameParams, normalDecode), MEMBER(FrameParams, size),
            MEMBER(FrameParams, backgroundDepth), MEMBER(FrameParams, filterDepthScale),
            MEMBER(FrameParams, pixelsPerMetre), MEMBER(FrameParams, pyramidLevels)}},
          {"mres/level_params.h",
           "LevelParams",
           sizeof(params::LevelParams),
           "blendWeight",
           {MEMBER(LevelParams, levelSize), MEMBER(LevelParams, levelStride),
            MEMBER(LevelParams, levelHalfStride), MEMBER(LevelParams, coarserFromPixel),
            MEMBER(LevelParams, maskFromPixel), MEMBER(LevelParams, blendWeight),
            MEMBER(LevelParams, refineThreshold), MEMBER(LevelParams, filterTolerance),
            MEMBER(LevelParams, padding)}},
          {"mres/edges_params.h",
           "EdgesParams",
           sizeof(params::EdgesParams),
           "depthThreshold",
           {MEMBER(EdgesParams, depthSlope), MEMBER(EdgesParams, normalCosine),
            MEMBER(EdgesParams, depthThreshold), MEMBER(EdgesParams, depthRounding)}},
          {"mres/mask_blur_params.h",
           "MaskBlurParams",
           sizeof(params::MaskBlurParams),
           "float(radius)",
           {MEMBER(MaskBlurParams, axis), MEMBER(MaskBlurParams, radius), MEMBER(MaskBlurParams, finerRatio),
            ARRAY_MEMBER(MaskBlurParams, weights)}},
          {"effects/ssao_params.h",
           "SsaoParams",
           sizeof(params::SsaoParams),
           "radius",
           {MEMBER(SsaoParams, radius), MEMBER(SsaoParams, bias), MEMBER(SsaoParams, intensity),
            MEMBER(SsaoParams, sampleCount), ARRAY_MEMBER(SsaoParams, samples)}}};
}

GLint blockParameter(GLuint program, GLuint block, GLenum parameter) {
  GLint value = 0;
  glGetActiveUniformBlockiv(program, block, parameter, &value);
  return value;
}

void compareWithProgram(const Block& block, GLuint program) {
  const GLuint index = glGetUniformBlockIndex(program, block.name.c_str());
  ASSERT_NE(index, GL_INVALID_INDEX) << block.name;
  EXPECT_EQ(blockParameter(program, index, GL_UNIFORM_BLOCK_DATA_SIZE), static_cast<GLint>(block.size))
      << block.name;
  EXPECT_EQ(blockParameter(program, index, GL_UNIFORM_BLOCK_ACTIVE_UNIFORMS),
            static_cast<GLint>(block.members.size()))
      << block.name << " has members that this test does not know";
  for (const Member& member : block.members) {
    const char* name = member.name.c_str();
    GLuint uniform = GL_INVALID_INDEX;
    glGetUniformIndices(program, 1, &name, &uniform);
    ASSERT_NE(uniform, GL_INVALID_INDEX) << block.name << "." << member.name;
    GLint offset = -1;
    glGetActiveUniformsiv(program, 1, &uniform, GL_UNIFORM_OFFSET, &offset);
    EXPECT_EQ(offset, static_cast<GLint>(member.offset)) << block.name << "." << member.name;
  }
}

class ParamsLayout : public GlTest {};

TEST_F(ParamsLayout, EveryMemberIsWhereTheCompilersOfBothSidesPutIt) {
  const std::vector<glm::vec4> input{glm::vec4(0.0f)};
  for (const Block& block : allBlocks()) {
    static_cast<void>(evaluate("#include \"" + block.header + "\"", "vec4(" + block.use + ")", input, {},
                               [&](const gl::Program& program) { compareWithProgram(block, program.id()); }));
  }
}

}  // namespace
}  // namespace mres::test
