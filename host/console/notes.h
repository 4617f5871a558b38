#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace host {

/// Messages of libraries included, an error reads as a sentence. Of a shader compiler's log, the first line
/// says what is wrong.
std::string asSentence(std::string text);

/// Tells users what they should know, a line each; no more than a few, since a report has them all.
void writeNotes(std::ostream& out, const std::vector<std::string>& warnings);

}  // namespace host
