#include "host/console/memory_need.h"

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
// Of a comparison, each channel of the effect is read back, copied and written.
constexpr std::uint64_t kBytesPerRenderedPixel = 115;
constexpr std::uint64_t kBytesPerComparedPixel = 173;
constexpr std::uint64_t kBytesPerComparedValue = 27;
constexpr std::uint64_t kBytesPerPixelOfTruth = 32;  // on top of a comparison's
constexpr std::uint64_t kBytesOfProgramAndScene = 300'000'000;
constexpr std::uint64_t kBytesPerShadowTexel = 4;  // GL_DEPTH_COMPONENT24

std::uint64_t pixelsOf(glm::ivec2 size) {
  return static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
}

std::uint64_t bytesBesidesPixels(const PictureNeed& need) {
  return kBytesOfProgramAndScene + kBytesPerShadowTexel * pixelsOf(glm::ivec2(need.shadowMapSize));
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

PictureNeed needOf(const PictureSettings& settings, glm::ivec2 size) {
  return {.size = size,
          .channels = settings.effect == kSsgiEffect ? 3U : 1U,
          .shadowMapSize = settings.renderer.shadowMapSize};
}

std::uint64_t bytesOfRender(const PictureNeed& need) {
  return bytesBesidesPixels(need) + kBytesPerRenderedPixel * pixelsOf(need.size);
}

std::uint64_t bytesOfComparison(const PictureNeed& need) {
  return bytesBesidesPixels(need) +
         (kBytesPerComparedPixel + kBytesPerComparedValue * need.channels) * pixelsOf(need.size);
}

std::uint64_t bytesOfComparisonWithTruth(const PictureNeed& need) {
  return bytesOfComparison(need) + kBytesPerPixelOfTruth * pixelsOf(need.size);
}

std::uint64_t availableMemory() {
  return std::min({physicalMemory(), addressSpace(), limitIn("/sys/fs/cgroup/memory.max"),
                   limitIn("/sys/fs/cgroup/memory/memory.limit_in_bytes")});
}

void requireMemory(std::uint64_t needed, std::uint64_t available, const std::string& advice) {
  if (needed <= available) return;
  throw std::runtime_error(
      fmt::format("Pictures of that size need about {:.1f} GiB of memory, and there are {:.1f} GiB; {}.",
                  gibibytes(needed), gibibytes(available), advice));
}

}  // namespace host
