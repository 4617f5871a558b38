#include "host/console/interruption.h"

#include <csignal>
#include <cstdlib>

namespace host {
namespace {

volatile std::sig_atomic_t received = 0;

extern "C" void remember(int signal) {
  received = signal;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void deferInterrupts() {
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

void throwIfInterrupted() {
  if (received != 0) throw Interrupted();
}

void endByInterrupt() {
  const int signal = received;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
  std::abort();  // not reached: the signal's default action ends the process
}

}  // namespace host
