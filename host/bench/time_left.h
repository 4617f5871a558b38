#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace host {

/// How long work goes on, by how far it came in the time that it had.
class TimeLeft {
 public:
  using Seconds = std::chrono::duration<double>;

  /// That share of the work, 0..1, need not be done at all: it says nothing of how fast the rest goes.
  void skip(double share) { skipped_ += share; }

  /// With `share` done or skipped after `elapsed`; nothing as long as too little is done to tell.
  [[nodiscard]] std::optional<Seconds> at(double share, Seconds elapsed) const;

 private:
  double skipped_ = 0.0;
};

/// "4:07 min left", or "1:35 h left" from an hour on.
std::string describe(TimeLeft::Seconds left);

}  // namespace host
