#pragma once

#include <string>
#include <vector>

#include "host/measure/report.h"

namespace host {

/// A row of titles, then one for the results of each effect, number of samples and size: how many views,
/// speedup and error over them.
std::vector<std::vector<std::string>> summaryRows(const Json& report);

}  // namespace host
