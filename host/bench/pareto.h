// Techniques on the plane of time and error, where less of both is better.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/measure/report.h"

namespace host {

/// A technique as it was set, as means over the views of a plane.
struct ParetoPoint {
  std::string technique;  ///< one of techniqueNames()
  std::string name;       ///< with what tells it from others of that technique, as of result_names.h
  double time = 0.0;      ///< as a share of the full resolution's
  double rms = 0.0;       ///< this and the next three: of the error against the full resolution
  double max = 0.0;
  double blockPercentile99 = 0.0;
  double blockMax = 0.0;
  std::optional<double> convergedRms = std::nullopt;  ///< of the error against the converged picture
  std::optional<double> flickerRms = std::nullopt;    ///< of the change of the error along a path
  std::string dominator = {};  ///< one with less time and no more RMS, the fastest of these; empty: none
};

/// All points of one effect, number of samples and size. The first is the reference itself.
struct ParetoPlane {
  std::string effect;
  int samples = 0;  ///< of the reference
  std::string size;
  std::size_t views = 0;
  std::vector<ParetoPoint> points;
};

/// Of a report's timed results, as far as more than one technique was measured. Points that lack a view which
/// others have are left out: they would tell of the views and not of techniques.
std::vector<ParetoPlane> paretoPlanes(const Json& report);

/// Fills in each point's dominator.
void findDominators(std::vector<ParetoPoint>& points);

/// Where a technique is on the plane of time and an error of some kind.
struct ErrorAndTime {
  double error = 0.0;
  double time = 0.0;
};

/// The time at which a curve through the points, straight in the logarithm of time over that of the error,
/// has that error; nothing outside of the errors of its points.
std::optional<double> timeAlong(std::vector<ErrorAndTime> curve, double error);

/// The least time that a technique errs no more in: along its curve, or by a point of it that errs less.
/// Nothing if none of its points errs so little.
std::optional<double> timeWithin(const std::vector<ErrorAndTime>& curve, double error);

/// Those results that a report of several techniques shares with one that compares mres alone, as it is by
/// default; a report of one technique as it is.
Json withoutRivals(const Json& report);

}  // namespace host
