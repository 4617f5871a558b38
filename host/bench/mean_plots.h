// Plots of campaigns with many views: means over them, and how they scatter.
#pragma once

#include <string>
#include <vector>

#include "host/measure/report.h"

namespace host {

/// gnuplot commands; empty where no point would be a mean of several views. One view that has more points
/// than all have together is drawn besides. Figures 6 and 5 of the paper.
std::string meanSpeedupBySize(const std::vector<Json>& timedResults);
std::string meanSpeedupBySamples(const std::vector<Json>& timedResults);

/// A box for each effect, of the pictures that most views have, the largest of those; empty where views are
/// too few for boxes. Figure 10 of the paper.
std::string errorBoxes(const Json& report);

}  // namespace host
