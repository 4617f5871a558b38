// What the plots of reports have in common: points under names, and the gnuplot commands for them.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/measure/report.h"

namespace host {

using Point = std::pair<double, double>;
using Series = std::map<std::string, std::vector<Point>>;

/// As many as have lines of their own.
inline constexpr std::size_t kMostSeries = 12;

/// "hall 0".
std::string viewOf(const Json& result);
/// "1920x1080".
std::string sizeOf(const Json& result);
double megapixels(const Json& result);
/// "ssao, 64 samples".
std::string workOf(const Json& result);

/// Title and labels.
std::string axes(const std::string& title, const std::string& x, const std::string& y);

/// From zero up, with a line where both techniques are as fast.
std::string speedupScale();

/// The commands that plot `series`; empty for none.
std::string plotOf(const Series& series, const std::string& style);

}  // namespace host
