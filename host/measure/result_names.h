// What the tables, plots and pages call a report and its results.
#pragma once

#include <string>

#include "host/measure/report.h"

namespace host {

/// "hall 0".
std::string viewOf(const Json& result);
/// "hall 0 ssao".
std::string pictureOf(const Json& result);
/// "1920x1080".
std::string sizeOf(const Json& result);
double megapixels(const Json& result);
/// "ssao, 64 samples".
std::string workOf(const Json& result);
/// "mres", or "mres, budget 0.02", "full, 16 samples" where it is not as the reference or as by default.
std::string techniqueTitle(const Json& result);
int referenceSamplesOf(const Json& result);

/// "83 minutes" that all results took; empty for reports that do not tell.
std::string durationOf(const Json& report);

}  // namespace host
