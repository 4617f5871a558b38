// The report for people: one row a picture, then where the time goes.
#include <fmt/format.h>
#include <functional>

#include "host/measure/report.h"
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
      {"RMS", "{:.4f}", errorOf("rms")},
      {"max", "{:.3f}", errorOf("max")},
      {"PSNR", "{:.1f}", errorOf("psnr")},
      {"SSIM", "{:.4f}", errorOf("ssim")},
  };
  return kFigures;
}

std::string pictureName(const Json& result) {
  return fmt::format("{} {} {}x{} {} {}", result["scene"].get<std::string>(), result["camera"].get<int>(),
                     result["width"].get<int>(), result["height"].get<int>(),
                     result["effect"].get<std::string>(), result["samples"].get<int>());
}

std::vector<std::string> titles() {
  std::vector<std::string> row{"scene camera size effect samples"};
  for (const Figure& figure : figures()) row.emplace_back(figure.title);
  row.emplace_back("coverage %, fine to coarse");
  return row;
}

std::vector<std::string> rowOf(const Json& result) {
  std::vector<std::string> row{pictureName(result)};
  for (const Figure& figure : figures()) row.push_back(cell(figure.get(result), figure.format));
  row.push_back(coverageText(result["coverage"]));
  return row;
}

std::vector<std::string> meanRow(const Json& results) {
  std::vector<std::string> row{"mean"};
  for (const Figure& figure : figures()) {
    double sum = 0.0;
    bool complete = true;
    for (const Json& result : results) {
      const Json value = figure.get(result);
      complete = complete && !value.is_null();
      if (complete) sum += value.get<double>();
    }
    row.push_back(complete ? cell(sum / static_cast<double>(results.size()), figure.format) : "-");
  }
  return row;
}

/// Stages in the order in which they first appear, averaged over the results that have them.
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

std::string certainty(const Json& results) {
  if (results.size() != 1 || results[0]["speedup"].is_null()) return {};
  const Json& result = results[0];
  return fmt::format(
      "Speedup {:.2f}x, between {:.2f}x and {:.2f}x with 95 % confidence: {} interleaved pairs, {}.\n",
      result["speedup"].get<double>(), result["speedup_interval"][0].get<double>(),
      result["speedup_interval"][1].get<double>(), result["time_ms"]["runs"].get<int>(),
      result["clock"].get<std::string>());
}

}  // namespace

std::vector<std::vector<std::string>> tableRows(const Json& report) {
  const Json& results = report["results"];
  Rows rows{titles()};
  for (const Json& result : results) rows.push_back(rowOf(result));
  if (results.size() > 1) rows.push_back(meanRow(results));
  return rows;
}

std::string toTable(const Json& report) {
  const Json& results = report["results"];
  const Json& machine = report["machine"];
  std::string text =
      fmt::format("{}, {} cores\n\n", machine["renderer"].get<std::string>(), machine["cores"].get<int>());
  text += formatTable(tableRows(report));
  if (const std::string line = certainty(results); !line.empty()) text += "\n" + line;
  if (const Rows stages = stageRows(results); !stages.empty())
    text += "\nWhere the technique's time goes, stage by stage:\n" + formatTable(stages);
  return text;
}

}  // namespace host
