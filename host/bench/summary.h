#pragma once

#include <string>
#include <vector>

#include "host/measure/report.h"

namespace host {

/// A row of titles, then one for the results of each effect, number of samples and size: how many views,
/// speedup and error over them.
std::vector<std::vector<std::string>> summaryRows(const Json& report);

/// "The speedup is known within 5 % (95 % interval) for 41 of 120 timed pictures; the slowest has one pair."
/// Empty for a report without timing.
std::string speedupCertainty(const Json& report);

}  // namespace host
