#pragma once

#include <filesystem>
#include <string>

namespace host {

/// Runs the gnuplot commands of `script` into the SVG file `svg`, which appears whole or not at all, and
/// keeps the script beside it as .gp. Returns false if there is no gnuplot; throws std::runtime_error with a
/// sentence if it rejects the script, and Interrupted.
bool drawSvg(const std::filesystem::path& svg, const std::string& script);

/// `text` as a gnuplot string.
std::string gnuplotQuoted(const std::string& text);

}  // namespace host
