#include "tests/support/params_layout.h"

#include <gtest/gtest.h>

#include "tests/support/glsl_function.h"

namespace mres::test {
namespace {

GLint blockParameter(GLuint program, GLuint block, GLenum parameter) {
  GLint value = 0;
  glGetActiveUniformBlockiv(program, block, parameter, &value);
  return value;
}

void compareWithProgram(const ParamsBlock& block, GLuint program) {
  const GLuint index = glGetUniformBlockIndex(program, block.name.c_str());
  ASSERT_NE(index, GL_INVALID_INDEX) << block.name;
  EXPECT_EQ(blockParameter(program, index, GL_UNIFORM_BLOCK_DATA_SIZE), static_cast<GLint>(block.size))
      << block.name;
  EXPECT_EQ(blockParameter(program, index, GL_UNIFORM_BLOCK_ACTIVE_UNIFORMS),
            static_cast<GLint>(block.members.size()))
      << block.name << " has members that this test does not know";
  for (const ParamsMember& member : block.members) {
    const char* name = member.name.c_str();
    GLuint uniform = GL_INVALID_INDEX;
    glGetUniformIndices(program, 1, &name, &uniform);
    ASSERT_NE(uniform, GL_INVALID_INDEX) << block.name << "." << member.name;
    GLint offset = -1;
    glGetActiveUniformsiv(program, 1, &uniform, GL_UNIFORM_OFFSET, &offset);
    EXPECT_EQ(offset, static_cast<GLint>(member.offset)) << block.name << "." << member.name;
  }
}

}  // namespace

void expectSameLayout(const ParamsBlock& block, const std::string& preamble) {
  const std::vector<glm::vec4> input{glm::vec4(0.0f)};
  static_cast<void>(evaluate(preamble, "vec4(" + block.use + ")", input, {},
                             [&](const gl::Program& program) { compareWithProgram(block, program.id()); }));
}

}  // namespace mres::test
