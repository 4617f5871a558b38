#include "host/commands/progress.h"

#include <algorithm>
#include <cmath>
#include <fmt/ostream.h>
#include <iostream>
#include <unistd.h>
#include <utility>

namespace host {
namespace {

constexpr auto kPatience = std::chrono::seconds(1);
constexpr int kCells = 24;
constexpr const char* kEraseLine = "\r\033[K";  // ECMA-48: carriage return, erase to the end of the line

}  // namespace

ProgressBar::ProgressBar(std::ostream& out, bool isTerminal, Now now)
    : out_(out), isTerminal_(isTerminal), now_(std::move(now)), start_(now_()) {}

ProgressBar::~ProgressBar() {
  clear();
}

void ProgressBar::update(double share, std::string_view what) {
  if (!isTerminal_ || now_() - start_ < kPatience) return;
  const double done = std::clamp(share, 0.0, 1.0);
  const int filled = static_cast<int>(std::floor(done * kCells));
  fmt::print(out_, "{}[{:#<{}}{:.<{}}] {:3.0f} % {}", kEraseLine, "", filled, "", kCells - filled,
             done * 100.0, what);
  out_.flush();
  drawn_ = true;
}

void ProgressBar::clear() {
  if (!std::exchange(drawn_, false)) return;
  out_ << kEraseLine;
  out_.flush();
}

StderrProgressBar::StderrProgressBar() : ProgressBar(std::cerr, isatty(STDERR_FILENO) == 1) {}

}  // namespace host
