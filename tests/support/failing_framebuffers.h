#pragma once

namespace mres::test {

/// While it lives, the driver seems to find framebuffers incomplete after `good` complete ones.
class FailingFramebuffers {
 public:
  explicit FailingFramebuffers(int good);
  ~FailingFramebuffers();
  FailingFramebuffers(const FailingFramebuffers&) = delete;
  FailingFramebuffers& operator=(const FailingFramebuffers&) = delete;
  FailingFramebuffers(FailingFramebuffers&&) = delete;
  FailingFramebuffers& operator=(FailingFramebuffers&&) = delete;
};

}  // namespace mres::test
