#include "host/bench/plot_script.h"

#include <fmt/format.h>
#include <iterator>

#include "host/bench/gnuplot.h"

namespace host {

std::string axes(const std::string& x, const std::string& y) {
  return fmt::format("set xlabel {}\nset ylabel {}\n", gnuplotQuoted(x), gnuplotQuoted(y));
}

std::string speedupScale() {
  return "set yrange [0:*]\nset arrow from graph 0, first 1 to graph 1, first 1 nohead dashtype 2\n";
}

std::string plotOf(const Series& series, const std::string& style) {
  std::string blocks;
  std::string commands;
  for (const auto& [name, points] : series) {
    const std::string block = fmt::format("$series{}", std::distance(series.begin(), series.find(name)));
    blocks += block + " << EOD\n";
    for (const auto& [x, y] : points) blocks += fmt::format("{} {}\n", x, y);
    blocks += "EOD\n";
    commands += fmt::format("{}{} with {} title {}", commands.empty() ? "plot " : ", ", block, style,
                            gnuplotQuoted(name));
  }
  return series.empty() ? "" : blocks + commands + "\n";
}

}  // namespace host
