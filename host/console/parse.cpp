#include "host/console/parse.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numeric>
#include <utility>

#include "host/console/usage_error.h"

namespace host {
namespace {

constexpr std::size_t kMostSlips = 2;

template <class Number>
std::optional<Number> parseWhole(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Levenshtein's distance: insertions, deletions and replacements of a letter.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

/// Pixels, or 0 for what is no possible side.
int parseSide(const std::string& text) {
  const int side = parseWhole<int>(text).value_or(0);
  return side >= 1 && side <= kMaxImageSize ? side : 0;
}

}  // namespace

glm::ivec2 parseSize(const std::string& text) {
  static constexpr std::array<std::pair<std::string_view, glm::ivec2>, 4> kUsual{
      {{"720p", {1280, 720}}, {"1080p", {1920, 1080}}, {"1440p", {2560, 1440}}, {"4k", {3840, 2160}}}};
  for (const auto& [name, size] : kUsual)
    if (text == name) return size;

  const std::size_t cross = text.find('x');
  const glm::ivec2 size(parseSide(text.substr(0, cross)),
                        cross == std::string::npos ? 0 : parseSide(text.substr(cross + 1)));
  if (size.x == 0 || size.y == 0)
    throw UsageError(fmt::format("'{}' is no picture size; give one from 1x1 to {}x{} such as 1920x1080.",
                                 text, kMaxImageSize, kMaxImageSize));
  return size;
}

std::optional<int> parseCamera(const std::string& text) {
  if (text == "all") return std::nullopt;
  const auto camera = parseWhole<int>(text);
  if (!camera || *camera < 0)
    throw UsageError(fmt::format("'{}' is no camera; give its number from 0 on, or all.", text));
  return camera;
}

std::optional<double> parseNumber(std::string_view text) {
  const auto number = parseWhole<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

int parseCount(const std::string& text, std::string_view things, int least, int most) {
  const auto number = parseNumber(text);
  if (!number || *number < least || *number > most || *number != std::trunc(*number))
    throw UsageError(fmt::format("'{}' is no number of {}; give a whole number from {} to {}.", text, things,
                                 least, most));
  return static_cast<int>(*number);
}

Assignment parseAssignment(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    throw UsageError(fmt::format("'{}' sets nothing; write key=value such as radius=0.4.", text));
  return {text.substr(0, equals), text.substr(equals + 1)};
}

std::vector<std::string> closestNames(std::string_view word, const std::vector<std::string>& candidates) {
  std::vector<std::pair<std::size_t, std::string>> near;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = editDistance(word, candidate);
    const bool contains = word.size() >= 3 && candidate.find(word) != std::string::npos;
    if (distance <= std::min(kMostSlips, candidate.size() / 2) || contains)
      near.emplace_back(distance, candidate);
  }
  std::ranges::stable_sort(near, {}, &std::pair<std::size_t, std::string>::first);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min<std::size_t>(near.size(), 3); ++i) names.push_back(near[i].second);
  return names;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates) {
  const std::vector<std::string> near = closestNames(word, candidates);
  if (!near.empty()) return fmt::format("; did you mean {}?", fmt::join(near, " or "));
  return fmt::format("; use {}{}.", candidates.size() > 1 ? "one of " : "", fmt::join(candidates, ", "));
}

}  // namespace host
