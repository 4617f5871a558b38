#include "host/measure/report_table.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <functional>

#include "host/measure/result_names.h"
#include "host/measure/statistics.h"
#include "host/measure/techniques.h"
#include "host/measure/text_table.h"

namespace host {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// "-" for null: not measured, or infinite.
std::string cell(const Json& value, const char* format) {
  return value.is_null() ? "-" : fmt::format(fmt::runtime(format), value.get<double>());
}

std::string coverageText(const Json& coverage) {
  std::string text;
  for (const Json& share : coverage)
    text += fmt::format("{}{:.1f}", text.empty() ? "" : " ", share.get<double>() * 100.0);
  return text;
}

/// A figure of a result that a mean makes sense of.
struct Figure {
  const char* title;
  const char* format;
  std::function<Json(const Json& result)> get;
};

const std::vector<Figure>& figures() {
  static const auto medianOf = [](const char* key) {
    return [key](const Json& result) { return result[key].is_null() ? Json() : result[key]["median"]; };
  };
  static const auto errorOf = [](const char* key) {
    return [key](const Json& result) { return result["error"].is_null() ? Json() : result["error"][key]; };
  };
  static const std::vector<Figure> kFigures{
      {"full ms", "{:.1f}", medianOf("reference_time_ms")},
      {"ms", "{:.1f}", medianOf("time_ms")},
      {"speedup", "{:.2f}x", [](const Json& result) { return result["speedup"]; }},
      {"efficiency", "{:.2f}", [](const Json& result) { return result.value("efficiency", Json()); }},
      {"RMS", "{:.4f}", errorOf("rms")},
      {"max", "{:.3f}", errorOf("max")},
      {"PSNR", "{:.1f}", errorOf("psnr")},
      {"SSIM", "{:.4f}", errorOf("ssim")},
  };
  return kFigures;
}

constexpr std::array kNames{"scene", "camera", "size", "effect", "samples"};

/// The technique goes without saying where it is mres's as it comes.
std::string effectAndTechnique(const Json& result) {
  const auto effect = result["effect"].get<std::string>();
  const std::string technique = techniqueTitle(result);
  return technique == kMresTechnique ? effect : fmt::format("{} by {}", effect, technique);
}

std::vector<std::string> namesOf(const Json& result) {
  return {result["scene"].get<std::string>(), result["camera"].dump(), sizeOf(result),
          effectAndTechnique(result), result["samples"].dump()};
}

/// How far the speedup's interval reaches to either side at most, where there are enough pairs for one.
std::string uncertainty(const Json& result) {
  const Json& interval = result["speedup_interval"];
  if (interval.is_null() || result["time_ms"]["runs"].get<std::size_t>() < RatioEstimate::kLeastPairs)
    return "-";
  const auto speedup = result["speedup"].get<double>();
  const double most = std::max(interval[1].get<double>() - speedup, speedup - interval[0].get<double>());
  return fmt::format("{:.1f}", most / speedup * 100.0);
}

std::string runsText(const Json& result) {
  return result["time_ms"].is_null() ? "-" : result["time_ms"]["runs"].dump();
}

std::vector<std::string> titles() {
  std::vector<std::string> row(kNames.begin(), kNames.end());
  for (const Figure& figure : figures()) row.emplace_back(figure.title);
  row.insert(row.end(), {"runs", "±%", "coverage %, fine to coarse"});
  return row;
}

std::vector<std::string> rowOf(const Json& result) {
  std::vector<std::string> row = namesOf(result);
  for (const Figure& figure : figures()) row.push_back(cell(figure.get(result), figure.format));
  row.insert(row.end(), {runsText(result), uncertainty(result), coverageText(result["coverage"])});
  return row;
}

/// "-" where a result lacks the figure.
std::string meanCell(const Json& results, const Figure& figure) {
  std::vector<double> values;
  for (const Json& result : results) {
    const Json value = figure.get(result);
    if (value.is_null()) return "-";
    values.push_back(value.get<double>());
  }
  return cell(mean(values), figure.format);
}

std::vector<std::string> meanRow(const Json& results) {
  std::vector<std::string> row(kNames.size());
  row.front() = "mean";
  for (const Figure& figure : figures()) row.push_back(meanCell(results, figure));
  return row;
}

bool agreeIn(const Json& results, std::initializer_list<const char*> fields) {
  return std::ranges::all_of(results, [&](const Json& result) {
    return std::ranges::all_of(fields, [&](const char* field) { return result[field] == results[0][field]; });
  });
}

/// Stages in the order in which they first appear, as means over all results.
Rows stageRows(const Json& results) {
  Json sums = Json::object();
  double total = 0.0;
  for (const Json& result : results)
    for (const auto& [name, milliseconds] : result["stages_ms"].items()) {
      sums[name] = sums.value(name, 0.0) + milliseconds.get<double>();
      total += milliseconds.get<double>();
    }
  Rows rows;
  for (const auto& [name, sum] : sums.items())
    rows.push_back({"  " + name,
                    fmt::format("{:.1f} ms", sum.get<double>() / static_cast<double>(results.size())),
                    fmt::format("{:.0f} %", sum.get<double>() / total * 100.0)});
  return rows;
}

std::string certainty(const Json& result) {
  if (result["speedup"].is_null()) return {};
  const auto runs = result["time_ms"]["runs"].get<std::size_t>();
  std::string text = fmt::format("Speedup {:.2f}x", result["speedup"].get<double>());
  if (runs >= RatioEstimate::kLeastPairs)
    text +=
        fmt::format(", between {:.2f}x and {:.2f}x with 95 % confidence",
                    result["speedup_interval"][0].get<double>(), result["speedup_interval"][1].get<double>());
  return fmt::format("\n{}: {} interleaved pair{}, {}.\n", text, runs, runs == 1 ? "" : "s",
                     result["clock"].get<std::string>());
}

/// A sentence for each picture that the plain effect was faster for.
std::string fallBacks(const Json& results) {
  std::string text;
  for (const Json& result : results) {
    const Json plan = result.value("plan", Json());
    if (plan.is_null() || !plan["falls_back"].get<bool>()) continue;
    text += fmt::format(
        "\n{}, camera {}, {}, {}: the plain effect stood in for levels, which would take {:.1f} ms instead "
        "of "
        "{:.1f}.\n",
        result["scene"].get<std::string>(), result["camera"].dump(), result["effect"].get<std::string>(),
        sizeOf(result), plan["levels_ms"].get<double>(), plan["plain_ms"].get<double>());
  }
  return text;
}

}  // namespace

Rows tableRows(const Json& report) {
  Rows rows{titles()};
  for (const Json& result : report["results"]) rows.push_back(rowOf(result));
  return rows;
}

std::string toTable(const Json& report) {
  const Json& results = report["results"];
  const Json& machine = report["machine"];
  Rows rows = tableRows(report);
  if (results.size() > 1 && agreeIn(results, {"scene", "width", "height", "effect", "samples"}))
    rows.push_back(meanRow(results));
  std::string text =
      fmt::format("{}, {} cores\n\n", machine["renderer"].get<std::string>(), machine["cores"].get<int>());
  text += formatTable(rows);
  if (results.size() == 1) text += certainty(results[0]);
  text += fallBacks(results);
  const Rows stages = agreeIn(results, {"effect"}) ? stageRows(results) : Rows();
  if (!stages.empty()) text += "\nWhere the technique's time goes, stage by stage:\n" + formatTable(stages);
  return text;
}

}  // namespace host
