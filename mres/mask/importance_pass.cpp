#include "mres/mask/importance_pass.h"

namespace mres {
namespace {

constexpr const char* kShader = "mres/importance.frag";

}  // namespace

ImportancePass::ImportancePass(const gl::ShaderLibrary& library)
    : maximum_(makePassProgram(library, kShader, "#define COMBINE max\n")),
      minimum_(makePassProgram(library, kShader, "#define COMBINE min\n")) {}

void ImportancePass::draw(PassContext& context, MaskCombination combination, const gl::Texture2D& edges,
                          GLuint importance, glm::ivec2 fullSize) {
  const gl::Scope scope(context.profiler, "mres.importance");
  if (target_.size() != edges.size()) target_ = gl::RenderTarget(edges.size(), {GL_R8}, 0, "mres.importance");
  gl::bindTexture(kSourceUnit, edges.id(), context.nearest);
  gl::bindTexture(kMaskUnit, importance, context.linear);
  const gl::Program& program = combination == kCombineByMinimum ? minimum_ : maximum_;
  glUseProgram(program.id());
  const glm::vec2 screenFromTexel = 2.0f / glm::vec2(fullSize);
  glUniform2fv(program.uniformLocation("screenFromTexel"), 1, &screenFromTexel.x);
  target_.bind();
  context.triangle.draw();
}

}  // namespace mres
