#pragma once

#include <string>
#include <vector>

#include "host/bench/pareto.h"

namespace host {

using TableRows = std::vector<std::vector<std::string>>;

/// What the tables of rivals tell, in sentences.
inline constexpr const char* kParetoMeaning =
    "Each technique with the same effect, noise, filter and formats, as means over the views: time as a "
    "share "
    "of full resolution's, each picture timed in turn with it; errors against the picture at full "
    "resolution, "
    "over all pixels and over blocks of 8x8. A technique is dominated where another one takes less time and "
    "has no more RMS.";
inline constexpr const char* kParetoRatioMeaning =
    "How many times mres's time a technique takes: where both have an RMS of 0.005 or 0.010, along their "
    "curves, and at each of its own points where 99 % of the blocks err no more. Above 1, mres is faster.";

/// "ssao 64, 1920x1080, 3 views".
std::string titleOf(const ParetoPlane& plane);

/// A row of titles, then one for each point.
TableRows paretoRows(const ParetoPlane& plane);

/// A row of titles, then one for each technique but mres.
TableRows paretoRatioRows(const ParetoPlane& plane);

/// All of it in Markdown, for documents; empty for a report of one technique.
std::string paretoMarkdown(const Json& report);

}  // namespace host
