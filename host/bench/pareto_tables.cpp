#include "host/bench/pareto_tables.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>

#include "host/measure/techniques.h"

namespace host {
namespace {

constexpr std::array kWantedRms{0.005, 0.010};

constexpr const char* kNotReached = "not reached";

using Member = double ParetoPoint::*;
using Technique = std::vector<const ParetoPoint*>;

std::map<std::string, Technique> byTechnique(const ParetoPlane& plane) {
  std::map<std::string, Technique> techniques;
  for (const ParetoPoint& point : plane.points) techniques[point.technique].push_back(&point);
  return techniques;
}

std::vector<ErrorAndTime> curveOf(const Technique& technique, Member error) {
  std::vector<ErrorAndTime> curve;
  curve.reserve(technique.size());
  for (const ParetoPoint* point : technique) curve.push_back({point->*error, point->time});
  return curve;
}

std::string numberOr(const std::optional<double>& value, const char* format, const char* otherwise) {
  return value ? fmt::format(fmt::runtime(format), *value) : otherwise;
}

std::string ratioAtRms(const Technique& technique, const Technique& mres, double rms) {
  const auto own = timeWithin(curveOf(technique, &ParetoPoint::rms), rms);
  const auto other = timeWithin(curveOf(mres, &ParetoPoint::rms), rms);
  return own && other ? fmt::format("{:.2f}", *own / *other) : kNotReached;
}

/// At the points whose blocks err as much as some on mres's curve: the least and the greatest.
std::string ratiosAtBlockError(const Technique& technique, const Technique& mres) {
  const std::vector<ErrorAndTime> curve = curveOf(mres, &ParetoPoint::blockPercentile99);
  std::vector<double> ratios;
  for (const ParetoPoint* point : technique)
    if (const auto time = timeAlong(curve, point->blockPercentile99)) ratios.push_back(point->time / *time);
  if (ratios.empty()) return kNotReached;
  const auto [least, greatest] = std::ranges::minmax(ratios);
  return ratios.size() == 1 ? fmt::format("{:.2f}", least) : fmt::format("{:.2f} to {:.2f}", least, greatest);
}

std::string toMarkdown(const TableRows& rows) {
  std::string text;
  for (const std::vector<std::string>& row : rows) {
    for (const std::string& cell : row) text += "| " + cell + " ";
    text += "|\n";
    if (&row != &rows.front()) continue;
    for (std::size_t i = 0; i < row.size(); ++i) text += i == 0 ? "| :-- " : "| --: ";
    text += "|\n";
  }
  return text;
}

}  // namespace

std::string titleOf(const ParetoPlane& plane) {
  return fmt::format("{} {}, {}, {} view{}", plane.effect, plane.samples, plane.size, plane.views,
                     plane.views == 1 ? "" : "s");
}

TableRows paretoRows(const ParetoPlane& plane) {
  TableRows rows{{"technique", "time, %", "RMS", "max", "99 % of blocks", "worst block", "converged RMS",
                  "flicker RMS", "dominated by"}};
  for (const ParetoPoint& point : plane.points)
    rows.push_back({point.name, fmt::format("{:.1f}", point.time * 100.0), fmt::format("{:.4f}", point.rms),
                    fmt::format("{:.3f}", point.max), fmt::format("{:.4f}", point.blockPercentile99),
                    fmt::format("{:.3f}", point.blockMax), numberOr(point.convergedRms, "{:.4f}", "-"),
                    numberOr(point.flickerRms, "{:.4f}", "-"),
                    point.dominator.empty() ? "-" : point.dominator});
  return rows;
}

TableRows paretoRatioRows(const ParetoPlane& plane) {
  TableRows rows{{"technique"}};
  for (const double rms : kWantedRms) rows.front().push_back(fmt::format("at RMS {:.3f}", rms));
  rows.front().emplace_back("at equal 99 % of blocks");
  const std::map<std::string, Technique> techniques = byTechnique(plane);
  const auto mres = techniques.find(kMresTechnique);
  for (const auto& [name, technique] : techniques) {
    if (mres == techniques.end() || name == kMresTechnique) continue;
    std::vector<std::string> row{name};
    for (const double rms : kWantedRms) row.push_back(ratioAtRms(technique, mres->second, rms));
    row.push_back(ratiosAtBlockError(technique, mres->second));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string paretoMarkdown(const Json& report) {
  const std::vector<ParetoPlane> planes = paretoPlanes(report);
  if (planes.empty()) return "";
  std::string text = fmt::format("{}\n\n{}\n", kParetoMeaning, kParetoRatioMeaning);
  for (const ParetoPlane& plane : planes)
    text += fmt::format("\n**{}**\n\n{}\n{}", titleOf(plane), toMarkdown(paretoRows(plane)),
                        toMarkdown(paretoRatioRows(plane)));
  return text;
}

}  // namespace host
