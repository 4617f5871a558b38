#include "tests/support/failing_framebuffers.h"

#include <epoxy/gl.h>

namespace mres::test {
namespace {

using CheckFramebufferStatus = decltype(glCheckFramebufferStatus);

int goodLeft = 0;
CheckFramebufferStatus driversOwn = nullptr;

GLenum checkSomeFramebufferStatus(GLenum target) {
  return goodLeft-- > 0 ? driversOwn(target) : GL_FRAMEBUFFER_UNSUPPORTED;
}

}  // namespace

FailingFramebuffers::FailingFramebuffers(int good) {
  static_cast<void>(glCheckFramebufferStatus(GL_FRAMEBUFFER));  // libepoxy looks up functions on first use
  driversOwn = glCheckFramebufferStatus;
  goodLeft = good;
  glCheckFramebufferStatus = checkSomeFramebufferStatus;
}

FailingFramebuffers::~FailingFramebuffers() {
  glCheckFramebufferStatus = driversOwn;
}

}  // namespace mres::test
