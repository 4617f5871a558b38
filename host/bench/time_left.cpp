#include "host/bench/time_left.h"

#include <cmath>
#include <fmt/format.h>

namespace host {
namespace {

constexpr double kLeastShare = 0.005;

}  // namespace

std::optional<TimeLeft::Seconds> TimeLeft::at(double share, Seconds elapsed) const {
  const double done = share - skipped_;
  if (done < kLeastShare) return std::nullopt;
  return elapsed * ((1.0 - share) / done);
}

std::string describe(TimeLeft::Seconds left) {
  const long seconds = std::lround(left.count());
  constexpr long kMinute = 60;
  constexpr long kHour = 60 * kMinute;
  if (seconds < kHour) return fmt::format("{}:{:02} min left", seconds / kMinute, seconds % kMinute);
  const long minutes = std::lround(left.count() / kMinute);
  return fmt::format("{}:{:02} h left", minutes / kMinute, minutes % kMinute);
}

}  // namespace host
