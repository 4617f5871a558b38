#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "host/measure/report.h"

namespace host {

/// Draws the plots that the report has the data for into `directory`/plots, from nothing but the report.
/// Returns their files relative to `directory`, or nothing if there is no gnuplot.
std::optional<std::vector<std::filesystem::path>> drawPlots(const Json& report,
                                                            const std::filesystem::path& directory);

}  // namespace host
