#include "host/bench/page.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <kainjow/mustache.hpp>
#include <map>
#include <span>
#include <stdexcept>
#include <system_error>

#include "host/bench/pareto_tables.h"
#include "host/bench/summary.h"
#include "host/bench/truth_summary.h"
#include "host/image/data_uri.h"
#include "host/measure/picture_names.h"
#include "host/measure/report_table.h"
#include "host/measure/result_names.h"

namespace host {
std::span<const PageFile> pageFiles();  // generated

namespace fs = std::filesystem;
namespace {

using kainjow::mustache::data;
using List = kainjow::mustache::list;
using Object = kainjow::mustache::object;

std::string pageFile(std::string_view name) {
  const auto file = std::ranges::find(pageFiles(), name, &PageFile::name);
  if (file == pageFiles().end()) throw std::logic_error(fmt::format("there is no page file '{}'", name));
  return std::string(file->text);
}

data cellsOf(const std::vector<std::string>& cells) {
  return List(cells.begin(), cells.end());
}

data tableOf(const std::vector<std::vector<std::string>>& rows) {
  List body;
  for (std::size_t i = 1; i < rows.size(); ++i) body.push_back(Object{{"cells", cellsOf(rows[i])}});
  return Object{{"titles", cellsOf(rows.front())}, {"rows", body}};
}

data plotsOf(const std::vector<Plot>& plots, const fs::path& folder) {
  List list;
  for (const Plot& plot : plots)
    list.push_back(Object{{"title", plot.title}, {"uri", dataUri(folder / plot.file, "image/svg+xml")}});
  return list;
}

std::string titleOf(const Json& result) {
  return fmt::format("{}, {}, {}", host::viewOf(result), workOf(result), sizeOf(result));
}

double rmsOf(const Json& result) {
  return result["error"]["rms"].get<double>();
}

/// The result with the greatest RMS; null where no error was measured.
const Json* greatestErrorOf(const Json& report) {
  const Json* greatest = nullptr;
  for (const Json& result : report["results"]) {
    if (result["error"].is_null()) continue;
    if (!greatest || rmsOf(result) > rmsOf(*greatest)) greatest = &result;
  }
  return greatest;
}

Object errorOf(const Json& result) {
  return Object{{"title", titleOf(result)}, {"rms", fmt::format("{:.4f}", rmsOf(result))}};
}

bool hasPicture(const Json& result, const char* subject, const fs::path& folder) {
  std::error_code ignored;  // what cannot be looked at cannot be shown
  const Json& pictures = result["pictures"];
  return pictures.contains(subject) &&
         fs::is_regular_file(folder / pictures[subject].get<std::string>(), ignored);
}

bool hasPictures(const Json& result, std::span<const char* const> subjects, const fs::path& folder) {
  return std::ranges::all_of(subjects,
                             [&](const char* subject) { return hasPicture(result, subject, folder); });
}

/// A picture of a view. The level map has few colours and sharp borders: no JPEG.
std::string uriOf(const fs::path& file, std::string_view subject) {
  return subject == kLevelsPicture ? dataUri(file, "image/png") : jpegDataUri(file);
}

std::string figuresOf(const Json& result) {
  std::string text;
  if (!result["speedup"].is_null())
    text += fmt::format("{:.2f} times as fast, ", result["speedup"].get<double>());
  return text + (result["error"].is_null() ? "" : fmt::format("RMS {:.4f}", rmsOf(result)));
}

data viewOf(const Json& result, const fs::path& folder) {
  const Json& pictures = result["pictures"];
  Object view{{"title", titleOf(result)},
              {"figures", figuresOf(result)},
              {"enhancement", fmt::format("{}", pictures.value(kDifferenceEnhancementName, 1.0))}};
  for (const char* subject : kViewPictures)
    view[subject] = uriOf(folder / pictures[subject].get<std::string>(), subject);
  return view;
}

List viewsOf(const Json& report, const fs::path& folder) {
  List views;
  for (const Json& result : report["results"])
    if (hasPictures(result, kViewPictures, folder)) views.push_back(viewOf(result, folder));
  return views;
}

data worstPlaceOf(const Json& result, const fs::path& folder) {
  const Json& error = result["error"];
  Object place{
      {"title", titleOf(result)},
      {"figures",
       fmt::format("RMS {:.4f}, of the worst block {:.3f}, of 99 % of the blocks at most {:.3f}",
                   rmsOf(result), error["block_max"].get<double>(), error["block_p99"].get<double>())}};
  for (const char* subject : kWorstPlacePictures)
    place[subject] = jpegDataUri(folder / result["pictures"][subject].get<std::string>());
  return place;
}

/// The worst first.
List worstPlacesOf(const Json& report, const fs::path& folder) {
  std::vector<const Json*> results;
  for (const Json& result : report["results"])
    if (hasPictures(result, kWorstPlacePictures, folder) && result["error"].contains("block_max"))
      results.push_back(&result);
  std::ranges::stable_sort(results, std::greater(),
                           [](const Json* result) { return (*result)["error"]["block_max"].get<double>(); });
  List places;
  for (const Json* result : results) places.push_back(worstPlaceOf(*result, folder));
  return places;
}

List planesOf(const Json& report) {
  List list;
  for (const ParetoPlane& plane : paretoPlanes(report))
    list.push_back(Object{{"title", titleOf(plane)},
                          {"points", tableOf(paretoRows(plane))},
                          {"ratios", tableOf(paretoRatioRows(plane))}});
  return list;
}

/// Of each scene that has some, in sentences.
List warningsOf(const Json& report) {
  std::map<std::string, List> scenes;
  for (const Json& result : report["results"]) {
    List& sentences = scenes[result["scene"]];
    if (!sentences.empty()) continue;
    for (const Json& sentence : result.value("warnings", Json::array()))
      sentences.push_back(sentence.get<std::string>());
  }
  List list;
  for (const auto& [scene, sentences] : scenes)
    if (!sentences.empty()) list.push_back(Object{{"scene", scene}, {"sentences", sentences}});
  return list;
}

/// Of each effect, with the samples that the tables tell left out.
data settingsOf(const Json& report) {
  std::map<std::string, List> effects;
  for (const Json& result : report["results"]) {
    List& entries = effects[result["effect"]];
    if (!entries.empty()) continue;
    for (const auto& [name, value] : result["settings"].items())
      if (name != "samples") entries.push_back(Object{{"name", name}, {"value", value.dump()}});
  }
  List list;
  for (const auto& [effect, entries] : effects)
    list.push_back(Object{{"effect", effect}, {"entries", entries}});
  return list;
}

}  // namespace

std::string makePage(const Json& report, const std::vector<Plot>& plots, const fs::path& folder) {
  const Json& machine = report["machine"];
  const List views = viewsOf(report, folder);
  const List worstPlaces = worstPlacesOf(report, folder);
  const List warnings = warningsOf(report);
  const List planes = planesOf(report);
  const Json own = withoutRivals(report);
  Object page{{"style", pageFile("style.css")},
              {"script", pageFile("script.js")},
              {"renderer", machine.value("renderer", "")},
              {"driver", machine.value("version", "")},
              {"cores", machine.value("cores", Json(0)).dump()},
              {"version", report["version"].get<std::string>()},
              {"sortable_table", kainjow::mustache::partial([] { return pageFile("sortable_table.html"); })},
              {"summary", tableOf(summaryRows(own))},
              {"has_plots", !plots.empty()},
              {"plots", plotsOf(plots, folder)},
              {"has_views", !views.empty()},
              {"views", views},
              {"has_worst_places", !worstPlaces.empty()},
              {"worst_places", worstPlaces},
              {"table", tableOf(tableRows(report))},
              {"has_warnings", !warnings.empty()},
              {"warnings", warnings},
              {"settings", settingsOf(report)}};
  if (const std::string certainty = speedupCertainty(report); !certainty.empty())
    page["certainty"] = certainty;
  if (const Json* greatest = greatestErrorOf(own)) page["greatest_error"] = errorOf(*greatest);
  if (const auto truths = truthSummaryRows(own); !truths.empty())
    page["truth"] = Object{{"meaning", kTruthSummaryMeaning}, {"table", tableOf(truths)}};
  if (!planes.empty())
    page["rivals"] =
        Object{{"meaning", kParetoMeaning}, {"ratio_meaning", kParetoRatioMeaning}, {"planes", planes}};
  if (const std::string commit = report.value("commit", ""); !commit.empty()) page["commit"] = commit;
  if (report.contains("date")) page["date"] = report["date"].get<std::string>();
  if (const std::string duration = durationOf(report); !duration.empty()) page["duration"] = duration;
  kainjow::mustache::mustache pageTemplate(pageFile("page.html"));
  return pageTemplate.render(page);
}

}  // namespace host
