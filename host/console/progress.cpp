#include "host/console/progress.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iostream>
#include <string>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

namespace host {
namespace {

constexpr auto kPatience = std::chrono::seconds(1);
constexpr int kCells = 24;
constexpr const char* kEraseLine = "\r\033[K";  // ECMA-48: carriage return, erase to the end of the line

/// 0 where it is no terminal.
int columnsOf(int descriptor) {
  constexpr int kUsual = 80;  // of terminals that do not know
  if (isatty(descriptor) != 1) return 0;
  winsize size{};
  return ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : kUsual;
}

}  // namespace

ProgressBar::ProgressBar(std::ostream& out, int columns, Now now)
    : out_(out), columns_(static_cast<std::size_t>(columns)), now_(std::move(now)), start_(now_()) {}

ProgressBar::~ProgressBar() {
  clear();
}

void ProgressBar::update(double share, std::string_view what) {
  if (columns_ == 0 || now_() - start_ < kPatience) return;
  const double done = std::clamp(share, 0.0, 1.0);
  const int filled = static_cast<int>(std::floor(done * kCells));
  const std::string line =
      fmt::format("[{:#<{}}{:.<{}}] {:3.0f} % {}", "", filled, "", kCells - filled, done * 100.0, what);
  out_ << kEraseLine << line.substr(0, columns_ - 1);  // a line that wraps could not be erased
  out_.flush();
  drawn_ = true;
}

void ProgressBar::clear() {
  if (!std::exchange(drawn_, false)) return;
  out_ << kEraseLine;
  out_.flush();
}

StderrProgressBar::StderrProgressBar() : ProgressBar(std::cerr, columnsOf(STDERR_FILENO)) {}

}  // namespace host
