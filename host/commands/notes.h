#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace host {

/// Tells users what they should know, a line each; no more than a few, since a report has them all.
void writeNotes(std::ostream& out, const std::vector<std::string>& warnings);

}  // namespace host
