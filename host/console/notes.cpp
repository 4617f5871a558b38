#include "host/console/notes.h"

#include <algorithm>
#include <cctype>
#include <fmt/ostream.h>
#include <string_view>

namespace host {
namespace {

constexpr std::size_t kMostLines = 4;

}  // namespace

std::string asSentence(std::string text) {
  text = text.substr(0, text.find('\n'));
  if (text.empty()) return text;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  if (std::string_view(".!?").find(text.back()) == std::string_view::npos) text += '.';
  return text;
}

void writeNotes(std::ostream& out, const std::vector<std::string>& warnings) {
  // "and 1 more" would take the place of what it hides.
  const std::size_t shown = warnings.size() > kMostLines ? kMostLines - 1 : warnings.size();
  for (std::size_t i = 0; i < shown; ++i) {
    std::string line = warnings[i];
    std::ranges::replace(line, '\n', ' ');  // names in files may hold anything
    fmt::print(out, "mres: note: {}\n", line);
  }
  if (shown < warnings.size())
    fmt::print(out, "mres: note: And {} more; --json reports all.\n", warnings.size() - shown);
}

}  // namespace host
