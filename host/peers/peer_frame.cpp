#include "host/peers/peer_frame.h"

namespace host {

mres::PlannedLevel PeerFrame::level(int index) const {
  return {index, mres::levelSize(size, index), levels.at(static_cast<std::size_t>(index))};
}

void PeerFrame::drawEffect(const mres::gl::RenderTarget& target, int level, bool zoned) const {
  if (description().readsPyramid)
    mres::gl::bindTexture(mres::kSourceUnit, pyramid.texture().id(), context.nearestMip);
  effect.draw(context, target, level, zoned);
}

void PeerFrame::use(const mres::gl::Program& program) const {
  glUseProgram(program.id());
  glUniform4fv(program.uniformLocation("backgroundValue"), 1, &background.x);
}

void ensure(mres::gl::RenderTarget& target, glm::ivec2 size, GLenum format, const char* label) {
  if (target.size() != size) target = mres::gl::RenderTarget(size, {format}, 0, label);
}

double pixelShare(glm::ivec2 some, glm::ivec2 all) {
  const glm::dvec2 share = glm::dvec2(some) / glm::dvec2(all);
  return share.x * share.y;
}

}  // namespace host
