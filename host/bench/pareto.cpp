#include "host/bench/pareto.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "host/measure/result_names.h"
#include "host/measure/statistics.h"
#include "host/measure/techniques.h"

namespace host {
namespace {

using Results = std::vector<const Json*>;
using PlaneKey = std::tuple<std::string, int, double>;  // effect, samples, megapixels

std::set<std::string> techniquesOf(const Json& report) {
  std::set<std::string> names;
  for (const Json& result : report["results"]) names.insert(techniqueTitle(result));
  return names;
}

std::map<PlaneKey, std::map<std::string, Results>> timedByPlane(const Json& report) {
  std::map<PlaneKey, std::map<std::string, Results>> planes;
  for (const Json& result : report["results"]) {
    if (result["speedup"].is_null() || !result["error"].contains("block_p99")) continue;
    planes[{result["effect"], referenceSamplesOf(result), megapixels(result)}][techniqueTitle(result)]
        .push_back(&result);
  }
  return planes;
}

template <class Figure>
double meanOf(const Results& results, const Figure& figure) {
  std::vector<double> values;
  values.reserve(results.size());
  for (const Json* result : results) values.push_back(figure(*result));
  return mean(values);
}

/// Of those that have the figure at `path`, all of them numbers.
std::optional<double> meanOfKnown(const Results& results, const Json::json_pointer& path) {
  Results known;
  std::ranges::copy_if(results, std::back_inserter(known),
                       [&](const Json* result) { return result->contains(path); });
  if (known.empty()) return std::nullopt;
  return meanOf(known, [&](const Json& result) { return result.at(path).get<double>(); });
}

ParetoPoint pointOf(const std::string& name, const Results& results) {
  const auto meanError = [&](const char* figure) {
    return meanOf(results, [figure](const Json& result) { return result["error"][figure].get<double>(); });
  };
  return {.technique = results.front()->at("technique").get<std::string>(),
          .name = name,
          .time = meanOf(results, [](const Json& result) { return 1.0 / result["speedup"].get<double>(); }),
          .rms = meanError("rms"),
          .max = meanError("max"),
          .blockPercentile99 = meanError("block_p99"),
          .blockMax = meanError("block_max"),
          .convergedRms = meanOfKnown(results, Json::json_pointer("/truth/converged/rms")),
          .flickerRms = meanOfKnown(results, Json::json_pointer("/temporal/rms"))};
}

/// By the results of any technique: all were measured against it.
ParetoPoint referencePoint(const Results& results) {
  return {.technique = kFullTechnique,
          .name = kFullTechnique,
          .time = 1.0,
          .convergedRms = meanOfKnown(results, Json::json_pointer("/truth/converged/reference_rms"))};
}

ParetoPlane planeOf(const std::map<std::string, Results>& techniques) {
  std::size_t views = 0;
  Results all;
  for (const auto& [name, results] : techniques) {
    views = std::max(views, results.size());
    all.insert(all.end(), results.begin(), results.end());
  }
  ParetoPlane plane{.effect = all.front()->at("effect").get<std::string>(),
                    .samples = referenceSamplesOf(*all.front()),
                    .size = sizeOf(*all.front()),
                    .views = views,
                    .points = {referencePoint(all)}};
  for (const auto& [name, results] : techniques)
    if (results.size() == views) plane.points.push_back(pointOf(name, results));
  std::ranges::sort(plane.points.begin() + 1, plane.points.end(), {}, &ParetoPoint::time);
  findDominators(plane.points);
  return plane;
}

/// Between two points of a curve, the first with the smaller error. There is no way to no error at all.
double timeBetween(const ErrorAndTime& a, const ErrorAndTime& b, double error) {
  if (error == b.error) return b.time;
  if (error == a.error || a.error <= 0.0) return a.time;
  const double share = std::log(error / a.error) / std::log(b.error / a.error);
  return std::exp(std::lerp(std::log(a.time), std::log(b.time), share));
}

}  // namespace

std::vector<ParetoPlane> paretoPlanes(const Json& report) {
  std::vector<ParetoPlane> planes;
  if (techniquesOf(report).size() < 2) return planes;
  for (const auto& [key, techniques] : timedByPlane(report)) planes.push_back(planeOf(techniques));
  return planes;
}

void findDominators(std::vector<ParetoPoint>& points) {
  for (ParetoPoint& point : points) {
    const ParetoPoint* best = nullptr;
    for (const ParetoPoint& other : points)
      if (other.time < point.time && other.rms <= point.rms && (!best || other.time < best->time))
        best = &other;
    point.dominator = best ? best->name : "";
  }
}

std::optional<double> timeAlong(std::vector<ErrorAndTime> curve, double error) {
  std::ranges::sort(curve, {}, [](const ErrorAndTime& point) { return std::pair(point.error, point.time); });
  for (std::size_t i = 1; i < curve.size(); ++i)
    if (curve[i - 1].error <= error && error <= curve[i].error)
      return timeBetween(curve[i - 1], curve[i], error);
  return std::nullopt;
}

std::optional<double> timeWithin(const std::vector<ErrorAndTime>& curve, double error) {
  std::optional<double> least = timeAlong(curve, error);
  for (const ErrorAndTime& point : curve)
    if (point.error <= error) least = std::min(least.value_or(point.time), point.time);
  return least;
}

Json withoutRivals(const Json& report) {
  if (techniquesOf(report).size() < 2) return report;
  Json own = report;
  std::erase_if(own["results"].get_ref<Json::array_t&>(),
                [](const Json& result) { return techniqueTitle(result) != kMresTechnique; });
  return own;
}

}  // namespace host
