#include "host/commands/bench_page.h"

#include <array>
#include <fmt/format.h>
#include <utility>

namespace host {
namespace {

constexpr const char* kStyle =
    R"(body{font:16px/1.5 system-ui,sans-serif;color:#222;max-width:1200px;margin:2em auto;padding:0 1em}
table{border-collapse:collapse;font-variant-numeric:tabular-nums}
td,th{padding:.25em .8em;text-align:right;border-bottom:1px solid #ddd}
td:first-child,th:first-child{text-align:left}
.pictures{display:grid;grid-template-columns:repeat(auto-fit,minmax(340px,1fr));gap:1em}
figure{margin:0}img{max-width:100%}figcaption{color:#555})";

constexpr std::array<std::pair<const char*, const char*>, 5> kShown{
    {{"full", "full resolution"},
     {"mres", "multi-resolution"},
     {"difference", "difference, 8 times enhanced"},
     {"edges", "edges: red normals, green depth"},
     {"levels", "levels: red full, green half, blue quarter, black eighth"}}};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '&')
      result += "&amp;";
    else if (letter == '<')
      result += "&lt;";
    else if (letter == '"')
      result += "&quot;";
    else
      result += letter;
  }
  return result;
}

std::string row(const std::vector<std::string>& cells, const char* tag) {
  std::string text = "<tr>";
  for (const std::string& cell : cells) text += fmt::format("<{0}>{1}</{0}>", tag, escaped(cell));
  return text + "</tr>\n";
}

std::string table(const Json& report) {
  std::string text = "<table>\n";
  bool heading = true;
  for (const auto& cells : tableRows(report)) text += row(cells, std::exchange(heading, false) ? "th" : "td");
  return text + "</table>\n";
}

std::string figure(const std::string& file, const std::string& caption) {
  return fmt::format(
      "<figure><a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\"></a><figcaption>{1}</figcaption></figure>\n",
      escaped(file), escaped(caption));
}

std::string pictures(const Json& result) {
  const Json& files = result["pictures"];
  if (files.empty()) return "";
  std::string text = fmt::format("<h2>{}, camera {}</h2>\n<div class=\"pictures\">\n",
                                 escaped(result["scene"].get<std::string>()), result["camera"].get<int>());
  for (const auto& [subject, caption] : kShown)
    if (files.contains(subject)) text += figure(files[subject].get<std::string>(), caption);
  return text + "</div>\n";
}

}  // namespace

std::string makePage(const Json& report, const std::vector<std::filesystem::path>& plots) {
  const Json& machine = report["machine"];
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>mres "
      "bench</title>\n<style>{}</style>\n"
      "<h1>Multi-resolution against full resolution</h1>\n<p>{}, {} cores. Times are medians of interleaved "
      "runs.</p>\n",
      kStyle, escaped(machine["renderer"].get<std::string>()), machine["cores"].get<int>());
  page += table(report);
  for (const auto& plot : plots) page += figure(plot.generic_string(), "");
  for (const Json& result : report["results"]) page += pictures(result);
  return page + "</html>\n";
}

}  // namespace host
