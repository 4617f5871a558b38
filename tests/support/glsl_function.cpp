#include "tests/support/glsl_function.h"

#include <cstring>

#include "effects/common/embedded_shaders.h"
#include "mres/embedded_shaders.h"
#include "mres/gl/full_screen.h"
#include "mres/gl/render_target.h"
#include "tests/support/gl_test.h"

namespace mres::test {
namespace {

constexpr GLuint kUnitA = 6;
constexpr GLuint kUnitB = 7;

gl::Texture2D inputTexture(std::span<const glm::vec4> values) {
  return {GL_RGBA32F, {static_cast<int>(values.size()), 1}, "test.input", 1, values.data()};
}

}  // namespace

gl::ShaderLibrary shaderLibrary() {
  gl::ShaderLibrary library;
  library.add(embeddedShaders());
  library.add(effects::embeddedShaders());
  return library;
}

std::vector<glm::vec4> evaluate(const std::string& preamble, const std::string& expression,
                                std::span<const glm::vec4> a, std::span<const glm::vec4> b,
                                const std::function<void(const gl::Program&)>& prepare) {
  gl::ShaderLibrary library = shaderLibrary();
  library.add("test/evaluate.frag",
              "#version 330 core\n" + preamble +
                  "\nuniform sampler2D inputA, inputB;\nout vec4 result;\nvoid main() {\n"
                  "  ivec2 place = ivec2(gl_FragCoord.x, 0);\n"
                  "  vec4 a = texelFetch(inputA, place, 0);\n"
                  "  vec4 b = texelFetch(inputB, place, 0);\n"
                  "  result = " +
                  expression + ";\n}\n");
  const gl::Program program(library, {"common/full_screen.vert", "test/evaluate.frag", {}});
  const gl::Texture2D textureA = inputTexture(a);
  const gl::Texture2D textureB = inputTexture(b.empty() ? a : b);
  const gl::RenderTarget target({static_cast<int>(a.size()), 1}, {GL_RGBA32F}, 0, "test.result");
  const gl::SamplerName sampler = gl::makeSampler(gl::Filter::nearest);
  gl::bindTexture(kUnitA, textureA.id(), sampler);
  gl::bindTexture(kUnitB, textureB.id(), sampler);
  glUseProgram(program.id());
  program.setTextureUnit("inputA", kUnitA);
  program.setTextureUnit("inputB", kUnitB);
  if (prepare) prepare(program);
  target.bind();
  gl::FullScreenTriangle().draw();

  const std::vector<float> pixels = readPixels(target.color().id(), target.size(), 4);
  std::vector<glm::vec4> values(a.size());
  std::memcpy(values.data(), pixels.data(), pixels.size() * sizeof(float));
  return values;
}

}  // namespace mres::test
