#pragma once

#include <chrono>

namespace host {

/// Runs from when it is made.
class Stopwatch {
 public:
  [[nodiscard]] std::chrono::duration<double> elapsed() const { return Clock::now() - start_; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace host
