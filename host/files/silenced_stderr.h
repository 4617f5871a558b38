#pragma once

namespace host {

/// While it lives, nothing reaches the standard error stream: for libraries that print there besides
/// returning the error, such as libpng. Not for several threads at once.
class SilencedStderr {
 public:
  SilencedStderr();
  ~SilencedStderr();
  SilencedStderr(const SilencedStderr&) = delete;
  SilencedStderr& operator=(const SilencedStderr&) = delete;
  SilencedStderr(SilencedStderr&&) = delete;
  SilencedStderr& operator=(SilencedStderr&&) = delete;

 private:
  int stderr_;  ///< where it went before; negative where nothing could be silenced
};

}  // namespace host
