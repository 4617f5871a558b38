#pragma once

#include <functional>
#include <string>

namespace host {

/// Called as long work goes on, with the share that is done, 0..1, and what comes now. May throw to end the
/// work.
using WorkObserver = std::function<void(double share, const std::string& what)>;

/// Observes work that is a part of what `observe` observes: from one share of that to another.
inline WorkObserver partOf(const WorkObserver& observe, double from, double to) {
  return [&observe, from, to](double share, const std::string& what) {
    observe(from + (to - from) * share, what);
  };
}

}  // namespace host
