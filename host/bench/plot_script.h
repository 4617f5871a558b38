// What the plots of reports have in common: points under names, and the gnuplot commands for them.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace host {

using Point = std::pair<double, double>;
using Series = std::map<std::string, std::vector<Point>>;

/// As many as have lines of their own.
inline constexpr std::size_t kMostSeries = 12;

/// Their labels.
std::string axes(const std::string& x, const std::string& y);

/// From zero up, with a line where both techniques are as fast.
std::string speedupScale();

/// The commands that plot `series`; empty for none.
std::string plotOf(const Series& series, const std::string& style);

}  // namespace host
