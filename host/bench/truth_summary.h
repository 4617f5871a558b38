#pragma once

#include <string>
#include <vector>

#include "host/measure/report.h"

namespace host {

/// What the table of truthSummaryRows() tells, in sentences.
inline constexpr const char* kTruthSummaryMeaning =
    "How far the picture at full resolution and the multi-resolution picture each are from what the effect "
    "should be: RMS error against the same effect with thousands of samples and no filter, and against rays "
    "through the real geometry. Where both are about as far, multi-resolution loses nothing that the full "
    "resolution had.";

/// A row of titles, then one for the results of each effect, number of samples, size and truth: the errors of
/// reference and technique against it, means over the views. Empty for a report without truths.
std::vector<std::vector<std::string>> truthSummaryRows(const Json& report);

}  // namespace host
