#pragma once

#include <string>

#include "host/measure/report.h"

namespace host {

/// What is wrong with a report read from a file, for the middle of a sentence; nothing for one in which every
/// field that the tables, plots and pages read is there and of its type.
std::string faultOf(const Json& report);

}  // namespace host
