#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/measure/report.h"

namespace host {

struct Plot {
  std::filesystem::path file;  ///< relative to the folder of the report
  std::string title;
};

/// Draws the plots that the report has the data for into `directory`/plots, from nothing but the report, and
/// takes away those that were there. Returns nothing if there is no gnuplot.
std::optional<std::vector<Plot>> drawPlots(const Json& report, const std::filesystem::path& directory);

}  // namespace host
