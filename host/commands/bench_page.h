#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/measure/report.h"

namespace host {

/// The report as a web page: table, plots, pictures; files relative to it.
std::string makePage(const Json& report, const std::vector<std::filesystem::path>& plots);

}  // namespace host
