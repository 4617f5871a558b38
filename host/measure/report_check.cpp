#include "host/measure/report_check.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "host/measure/picture_names.h"

namespace host {
namespace {

using Check = bool (*)(const Json&);

bool isText(const Json& value) {
  return value.is_string();
}

bool isWhole(const Json& value) {
  return value.is_number_integer();
}

bool isObject(const Json& value) {
  return value.is_object();
}

bool isNumber(const Json& value) {
  return value.is_number();
}

bool isPositive(const Json& value) {
  return value.is_number() && value.get<double>() > 0.0;
}

template <Check check>
bool isNullOr(const Json& value) {
  return value.is_null() || check(value);
}

template <Check check>
bool isListOf(const Json& value) {
  return value.is_array() && std::ranges::all_of(value, check);
}

template <Check check>
bool isTableOf(const Json& value) {
  return value.is_object() && std::ranges::all_of(value, check);
}

template <Check check>
bool has(const Json& object, const char* name) {
  return object.is_object() && object.contains(name) && check(object.at(name));
}

bool isInterval(const Json& value) {
  return isListOf<isNumber>(value) && value.size() == 2;
}

bool isSummary(const Json& value) {
  return has<isNumber>(value, "median") && has<isNumber>(value, "min") && has<isNumber>(value, "max") &&
         has<isWhole>(value, "runs");
}

bool isError(const Json& value) {
  return has<isNumber>(value, "rms") && has<isNumber>(value, "max") &&
         has<isNullOr<isNumber>>(value, "psnr") && has<isNumber>(value, "ssim") &&
         (!value.contains("block_max") ||  // older reports lack it
          (has<isNumber>(value, "block_max") && has<isNumber>(value, "block_p99")));
}

/// Errors against a truth.
bool isTruth(const Json& value) {
  return has<isWhole>(value, "pixels") && has<isNumber>(value, "rms") && has<isNumber>(value, "max") &&
         has<isNumber>(value, "reference_rms") && has<isNumber>(value, "reference_max") &&
         (has<isWhole>(value, "samples") || has<isWhole>(value, "rays"));
}

bool isTemporal(const Json& value) {
  return has<isWhole>(value, "frames") && has<isNumber>(value, "rms");
}

bool isPlan(const Json& value) {
  return has<isText>(value, "reason") && value.contains("falls_back") && value["falls_back"].is_boolean() &&
         (!value["falls_back"].get<bool>() ||
          (has<isNumber>(value, "levels_ms") && has<isNumber>(value, "plain_ms")));
}

/// Files by what they show, and one number.
bool isPictures(const Json& value) {
  if (!value.is_object()) return false;
  for (const auto& [subject, entry] : value.items())
    if (!(subject == kDifferenceEnhancementName ? isNumber(entry) : isText(entry))) return false;
  return true;
}

bool isMachine(const Json& value) {
  return has<isText>(value, "renderer") && has<isText>(value, "version") && has<isWhole>(value, "cores");
}

struct Field {
  const char* name;
  Check isRight;
};

constexpr std::array kResultFields{Field{"scene", isText},
                                   Field{"triangles", isWhole},
                                   Field{"camera", isWhole},
                                   Field{"camera_name", isText},
                                   Field{"width", isWhole},
                                   Field{"height", isWhole},
                                   Field{"effect", isText},
                                   Field{"samples", isWhole},
                                   Field{"technique", isText},
                                   Field{"time_ms", isNullOr<isSummary>},
                                   Field{"reference_time_ms", isNullOr<isSummary>},
                                   Field{"clock", isNullOr<isText>},
                                   Field{"speedup", isNullOr<isPositive>},
                                   Field{"speedup_interval", isNullOr<isInterval>},
                                   Field{"error", isNullOr<isError>},
                                   Field{"coverage", isListOf<isNumber>},
                                   Field{"stages_ms", isTableOf<isNumber>},
                                   Field{"settings", isObject},
                                   Field{"pictures", isPictures}};

/// Fields that older reports lack.
constexpr std::array kLaterFields{Field{"reference_samples", isWhole},
                                  Field{"temporal", isNullOr<isTemporal>},
                                  Field{"truth", isNullOr<isTableOf<isTruth>>},
                                  Field{"seconds", isNumber},
                                  Field{"warnings", isListOf<isText>},
                                  Field{"work", isNullOr<isNumber>},
                                  Field{"floor_ms", isNullOr<isNumber>},
                                  Field{"efficiency", isNullOr<isNumber>},
                                  Field{"plan", isNullOr<isPlan>}};

/// A speedup comes with the times it is of, and plots show it with the error.
constexpr std::array kFieldsOfASpeedup{"time_ms", "reference_time_ms", "clock", "speedup_interval", "error"};

std::string faultOfResult(const Json& result) {
  if (!result.is_object()) return "is no object";
  for (const Field& field : kResultFields) {
    if (!result.contains(field.name)) return fmt::format("has no '{}'", field.name);
    if (!field.isRight(result.at(field.name))) return fmt::format("has a broken '{}'", field.name);
  }
  for (const Field& field : kLaterFields)
    if (result.contains(field.name) && !field.isRight(result.at(field.name)))
      return fmt::format("has a broken '{}'", field.name);
  if (result.at("speedup").is_null()) return "";
  for (const char* name : kFieldsOfASpeedup)
    if (result.at(name).is_null()) return fmt::format("has a speedup without '{}'", name);
  return "";
}

}  // namespace

std::string faultOf(const Json& report) {
  if (!report.is_object()) return "it is not JSON of a report";
  if (!has<isWhole>(report, "schema") || report.at("schema") != makeReport({}).at("schema"))
    return "its schema is another one";
  if (!has<isText>(report, "version")) return "it names no version of mres";
  if (!has<isText>(report, "commit")) return "it names no commit of mres";
  if (report.contains("date") && !isText(report.at("date"))) return "its date is no text";
  if (!has<isMachine>(report, "machine")) return "it names no machine";
  if (!report.contains("results") || !report.at("results").is_array()) return "it has no list of results";
  for (std::size_t i = 0; i < report.at("results").size(); ++i)
    if (const std::string fault = faultOfResult(report.at("results")[i]); !fault.empty())
      return fmt::format("result {} {}", i, fault);
  return "";
}

}  // namespace host
