#include "host/commands/plot_script.h"

#include <fmt/format.h>
#include <iterator>

#include "host/commands/gnuplot.h"

namespace host {

std::string viewOf(const Json& result) {
  return fmt::format("{} {}", result["scene"].get<std::string>(), result["camera"].get<int>());
}

std::string sizeOf(const Json& result) {
  return fmt::format("{}x{}", result["width"].get<int>(), result["height"].get<int>());
}

double megapixels(const Json& result) {
  return result["width"].get<double>() * result["height"].get<double>() / 1e6;
}

std::string workOf(const Json& result) {
  return fmt::format("{}, {} samples", result["effect"].get<std::string>(), result["samples"].get<int>());
}

std::string axes(const std::string& title, const std::string& x, const std::string& y) {
  return fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n", gnuplotQuoted(title), gnuplotQuoted(x),
                     gnuplotQuoted(y));
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
