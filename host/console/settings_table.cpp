#include "host/console/settings_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>

#include "host/console/usage_error.h"
#include "host/measure/text_table.h"

namespace host {
namespace {

std::string rangeText(const mres::SettingInfo& info, bool whole) {
  const char* unit = info.unit;
  return fmt::format("{}{} to {}{}{}", whole ? "a whole number from " : "", info.min, info.max,
                     *unit ? " " : "", unit);
}

std::optional<double> parseValue(const std::string& text) {
  if (text == "true" || text == "on") return 1.0;
  if (text == "false" || text == "off") return 0.0;
  return parseNumber(text);
}

}  // namespace

Json SettingsTable::toJsonValue(float value) {
  // The shortest text that reads back as the same float: 0.4, not 0.4000000059604645.
  return std::strtod(fmt::format("{}", value).c_str(), nullptr);
}

void SettingsTable::set(const Assignment& assignment) const {
  const Entry& entry = find(assignment.key);
  const auto value = parseValue(assignment.value);
  const bool inRange = value && *value >= entry.info.min && *value <= entry.info.max;
  if (!inRange || (entry.whole && std::trunc(*value) != *value))
    throw UsageError(fmt::format("'{}' is no value for the setting {}; give {}.", assignment.value,
                                 entry.name, rangeText(entry.info, entry.whole)));
  entry.set(*value);
}

const SettingsTable::Entry& SettingsTable::find(const std::string& name) const {
  const auto entry = std::ranges::find(entries_, name, &Entry::name);
  if (entry != entries_.end()) return *entry;
  std::vector<std::string> names;
  std::ranges::transform(entries_, std::back_inserter(names), &Entry::name);
  throw UsageError(fmt::format("There is no setting '{}'{}", name, suggestion(name, names)));
}

Json SettingsTable::values() const {
  Json values = Json::object();
  for (const Entry& entry : entries_) values[entry.name] = entry.get();
  return values;
}

std::string SettingsTable::describe() const {
  std::string text;
  for (const Entry& entry : entries_)
    text += fmt::format("  {}={}\n      {} [{}]\n", entry.name, entry.get().dump(), entry.info.meaning,
                        rangeText(entry.info, entry.whole));
  return text;
}

}  // namespace host
