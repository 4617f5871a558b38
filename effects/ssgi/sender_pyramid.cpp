#include "effects/ssgi/sender_pyramid.h"

#include <algorithm>

#include "effects/common/embedded_shaders.h"
#include "mres/embedded_shaders.h"
#include "mres/gl/render_target.h"
#include "mres/level/depth_pyramid.h"
#include "mres/level/pass_context.h"

namespace mres {
namespace {

constexpr const char* kLabel = "mres.ssgi.senders";

gl::Program makeProgram(bool fromPicture) {
  gl::ShaderLibrary library;
  library.add(embeddedShaders());
  library.add(effects::embeddedShaders());
  return makePassProgram(library, "effects/ssgi_senders.frag",
                         fromPicture ? "#define FROM_PICTURE 1\n" : "#define FROM_PICTURE 0\n");
}

}  // namespace

SenderPyramid::Pass::Pass(bool fromPicture, GLuint unit, GLuint paramsBinding)
    : program(makeProgram(fromPicture)), level(program.uniformLocation("level")) {
  program.setTextureUnit("source", static_cast<GLint>(unit));
  program.setBlockBinding("SsgiParams", paramsBinding);
}

SenderPyramid::SenderPyramid(GLuint unit, GLuint paramsBinding)
    : unit_(unit), fromPicture_(true, unit, paramsBinding), fromLevel_(false, unit, paramsBinding) {}

void SenderPyramid::attach(int level) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.id(), level);
}

/// Rounded up, so that each pixel of the full resolution has a texel.
void SenderPyramid::resize(glm::ivec2 fullSize) {
  if (fullSize_ == fullSize) return;
  const int levels = std::max(depthPyramidLevels(fullSize) - 1, 1);
  texture_ = gl::Texture2D(GL_RGBA16F, (fullSize + 1) / 2, kLabel, levels);
  attach(0);
  gl::requireComplete(kLabel);
  fullSize_ = fullSize;
}

void SenderPyramid::drawLevel(const Pass& pass, int level) const {
  attach(level);
  const glm::ivec2 size = glm::max(texture_.size() >> level, glm::ivec2(1));
  glViewport(0, 0, size.x, size.y);
  glUseProgram(pass.program.id());
  glUniform1i(pass.level, level);
  triangle_.draw();
}

void SenderPyramid::draw(glm::ivec2 fullSize) {
  resize(fullSize);
  drawLevel(fromPicture_, 0);
  gl::bindTexture(unit_, texture_.id(), nearestMip_);
  for (int level = 1; level < texture_.levels(); ++level) {
    // What is drawn into must not be readable.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level - 1);
    drawLevel(fromLevel_, level);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, texture_.levels() - 1);
}

}  // namespace mres
