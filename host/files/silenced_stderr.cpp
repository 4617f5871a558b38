#include "host/files/silenced_stderr.h"

#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace host {

SilencedStderr::SilencedStderr() : stderr_(dup(STDERR_FILENO)) {
  const int nowhere = stderr_ < 0 ? -1 : open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  std::fflush(stderr);
  dup2(nowhere, STDERR_FILENO);
  close(nowhere);
}

SilencedStderr::~SilencedStderr() {
  if (stderr_ < 0) return;
  std::fflush(stderr);
  dup2(stderr_, STDERR_FILENO);
  close(stderr_);
}

}  // namespace host
