#pragma once

#include <functional>
#include <string>

namespace host {

/// Called as long work goes on, with the share that is done, 0..1, and what comes now. May throw to end the
/// work.
using WorkObserver = std::function<void(double share, const std::string& what)>;

}  // namespace host
