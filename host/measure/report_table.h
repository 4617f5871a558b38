// The report for people.
#pragma once

#include <string>
#include <vector>

#include "host/measure/report.h"

namespace host {

/// A row of titles, and one for each result.
std::vector<std::vector<std::string>> tableRows(const Json& report);

/// Those rows aligned for a terminal. Where the results differ in nothing but their cameras, then also their
/// means; where they are of one effect, where its time goes.
std::string toTable(const Json& report);

}  // namespace host
