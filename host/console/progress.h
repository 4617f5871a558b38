#pragma once

#include <chrono>
#include <functional>
#include <ostream>
#include <string_view>

namespace host {

/// One line that shows how far long work is. Silent for the first second, and for ever where `out` is no
/// terminal: where it has no columns.
class ProgressBar {
 public:
  using Clock = std::chrono::steady_clock;
  using Now = std::function<Clock::time_point()>;

  ProgressBar(std::ostream& out, int columns, Now now = Clock::now);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ProgressBar(ProgressBar&&) = delete;
  ProgressBar& operator=(ProgressBar&&) = delete;

  /// `share` of the work, 0..1, is done, and `what` comes now.
  void update(double share, std::string_view what);

  /// Takes the line away, so that other output can be written; the next update brings it back.
  void clear();

 private:
  std::ostream& out_;
  std::size_t columns_;
  Now now_;
  Clock::time_point start_;
  bool drawn_ = false;
};

/// A bar on stderr.
class StderrProgressBar : public ProgressBar {
 public:
  StderrProgressBar();
};

}  // namespace host
