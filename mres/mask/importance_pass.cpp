#include "mres/mask/importance_pass.h"

namespace mres {
namespace {

constexpr const char* kShader = "mres/importance.frag";

}  // namespace

ImportancePass::ImportancePass(const gl::ShaderLibrary& library)
    : maximum_(makePassProgram(library, kShader, "#define BY_MINIMUM 0\n")),
      minimum_(makePassProgram(library, kShader, "#define BY_MINIMUM 1\n")) {}

const gl::Texture2D& ImportancePass::draw(PassContext& context, MaskCombination combination, int level,
                                          const gl::Texture2D& edges, const Frame& frame) {
  const gl::Scope scope(context.profiler, "mres.importance");
  gl::RenderTarget& target = targets_.at(static_cast<std::size_t>(level));
  if (target.size() != edges.size()) target = gl::RenderTarget(edges.size(), {GL_RG8}, 0, "mres.importance");
  gl::bindTexture(kSourceUnit, edges.id(), context.nearest);
  gl::bindTexture(kMaskUnit, frame.importance, context.linear);
  const gl::Program& program = combination == kCombineByMinimum ? minimum_ : maximum_;
  glUseProgram(program.id());
  const glm::vec2 screenFromTexel = static_cast<float>(2 << level) / glm::vec2(frame.size);
  glUniform2fv(program.uniformLocation("screenFromTexel"), 1, &screenFromTexel.x);
  target.bind();
  context.triangle.draw();
  return target.color();
}

void ImportancePass::fill(float value) const {
  for (const gl::RenderTarget& target : targets_) target.fill(value);
}

std::size_t ImportancePass::bytes() const {
  std::size_t sum = 0;
  for (const gl::RenderTarget& target : targets_) sum += target.bytes();
  return sum;
}

}  // namespace mres
