#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "host/console/parse.h"
#include "host/measure/report.h"
#include "mres/settings.h"

namespace host {

/// Every setting that users can change by name, gathered from the visit() of the settings structs: the one
/// place that --set, --help and the report read. The structs must outlive the table.
class SettingsTable {
 public:
  /// The names of the settings get `prefix` in front.
  template <class Settings>
  void add(Settings& settings, const std::string& prefix = "") {
    visit(settings, [&](const char* name, auto& member, const mres::SettingInfo& info) {
      addSetting(prefix + name, member, info);
    });
  }

  /// Throws UsageError with a sentence for an unknown key (with those that are near), or a value out of
  /// range.
  void set(const Assignment& assignment) const;

  /// Each name and its value.
  [[nodiscard]] Json values() const;

  /// One line a setting: name, default, range, unit, meaning.
  [[nodiscard]] std::string describe() const;

 private:
  struct Entry {
    std::string name;
    mres::SettingInfo info;
    bool whole;  ///< integers and switches
    std::function<void(double)> set;
    std::function<Json()> get;
  };

  template <class Value>
  void addSetting(const std::string& name, Value& member, const mres::SettingInfo& info) {
    entries_.push_back({name, info, std::is_integral_v<Value> || std::is_enum_v<Value>,
                        [&member](double value) { member = static_cast<Value>(value); },
                        [&member] { return toJsonValue(member); }});
  }
  static Json toJsonValue(bool value) { return value; }
  static Json toJsonValue(int value) { return value; }
  static Json toJsonValue(unsigned value) { return value; }
  static Json toJsonValue(float value);

  [[nodiscard]] const Entry& find(const std::string& name) const;

  std::vector<Entry> entries_;
};

}  // namespace host
