// The report that scripts rely on: one JSON object, as the page on the command line has it. Fields are added
// over time, never renamed.
#pragma once

#include <string>

#include "host/measure/measurement.h"

namespace host {

struct Machine {
  std::string renderer;
  std::string version;
  int cores = 0;
};

/// This process's cores and the current context's driver.
Machine machineOf(const std::string& renderer, const std::string& version);

Json toJson(const Measurement& measurement);

/// A report without results yet.
Json makeReport(const Machine& machine);

/// JSON as it is written to files and to stdout.
std::string toText(const Json& report);

/// Errors of a result against each truth by its name; null where there are none.
Json truthsOf(const Json& result);

/// "converged, 4096 samples".
std::string truthTitle(const std::string& name, const Json& truth);

/// How far technique and reference are from each truth, a row a picture and truth, aligned for a terminal;
/// empty for a report without truths.
std::string toTruthTable(const Json& report);

/// How much the technique flickers, a row a picture, aligned for a terminal; empty for a report without.
std::string toTemporalTable(const Json& report);

}  // namespace host
