#pragma once

#include <string>
#include <vector>

#include "host/bench/pareto.h"

namespace host {

/// gnuplot commands: time against RMS error, a line for each technique.
std::string paretoPlot(const ParetoPlane& plane);

/// "pareto-ssao-64-1920x1080".
std::string plotNameOf(const ParetoPlane& plane);

}  // namespace host
