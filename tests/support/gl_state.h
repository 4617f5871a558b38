#pragma once

#include <map>
#include <string>
#include <vector>

namespace mres::test {

/// Every value that glGet* tells of the context's state, by name; indexed state once an index.
using GlState = std::map<std::string, std::vector<double>>;

GlState captureGlState();

/// The names of what differs, with both values; empty if nothing does.
std::vector<std::string> differences(const GlState& before, const GlState& after);

}  // namespace mres::test
