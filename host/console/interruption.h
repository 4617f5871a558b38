#pragma once

#include <exception>

namespace host {

/// The user pressed Ctrl-C: unwinds to the command line, which ends as a process that SIGINT ended.
class Interrupted : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "interrupted"; }
};

/// From now on the first SIGINT or SIGTERM only makes throwIfInterrupted() throw, so that no file is left
/// half written; the second ends the process at once.
void deferInterrupts();

/// To be called between steps of long work.
void throwIfInterrupted();

/// Ends the process by the signal that came, as shells and make expect.
[[noreturn]] void endByInterrupt();

}  // namespace host
