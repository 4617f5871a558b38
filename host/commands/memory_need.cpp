#include "host/commands/memory_need.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <sys/resource.h>
#include <unistd.h>

namespace host {
namespace {

// From the peaks of resident memory on llvmpipe at 1920x1080 and 3840x2160, --json included. The techniques
// differ by less than a tenth, since the pictures weigh more than the levels: the one that takes more counts.
constexpr std::uint64_t kBytesPerRenderedPixel = 115;
constexpr std::uint64_t kBytesPerComparedPixel = 200;
constexpr std::uint64_t kBytesPerPixelOfTruth = 32;  // on top of a comparison's
constexpr std::uint64_t kBytesOfProgramAndScene = 300'000'000;

std::uint64_t pixelsOf(glm::ivec2 size) {
  return static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
}

std::uint64_t physicalMemory() {
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// What `ulimit -v` leaves.
std::uint64_t addressSpace() {
  rlimit limit{};
  return getrlimit(RLIMIT_AS, &limit) == 0 ? limit.rlim_cur : RLIM_INFINITY;
}

/// Of the control group, as containers see theirs; no limit where the file has none or is not there.
std::uint64_t limitIn(const char* file) {
  std::uint64_t bytes = 0;
  return std::ifstream(file) >> bytes ? bytes : std::numeric_limits<std::uint64_t>::max();
}

double gibibytes(std::uint64_t bytes) {
  return static_cast<double>(bytes) / (1U << 30U);
}

}  // namespace

std::uint64_t bytesOfRender(glm::ivec2 size) {
  return kBytesOfProgramAndScene + kBytesPerRenderedPixel * pixelsOf(size);
}

std::uint64_t bytesOfComparison(glm::ivec2 size) {
  return kBytesOfProgramAndScene + kBytesPerComparedPixel * pixelsOf(size);
}

std::uint64_t bytesOfComparisonWithTruth(glm::ivec2 size) {
  return bytesOfComparison(size) + kBytesPerPixelOfTruth * pixelsOf(size);
}

std::uint64_t availableMemory() {
  return std::min({physicalMemory(), addressSpace(), limitIn("/sys/fs/cgroup/memory.max"),
                   limitIn("/sys/fs/cgroup/memory/memory.limit_in_bytes")});
}

void requireMemory(std::uint64_t needed, std::uint64_t available) {
  if (needed <= available) return;
  throw std::runtime_error(
      fmt::format("Pictures of that size need about {:.1f} GiB of memory, and there are {:.1f} GiB; give "
                  "a smaller --size.",
                  gibibytes(needed), gibibytes(available)));
}

}  // namespace host
