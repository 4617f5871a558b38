#include "host/commands/memory_need.h"

#include <fmt/format.h>
#include <stdexcept>
#include <unistd.h>

namespace host {
namespace {

// From the peaks of resident memory on llvmpipe at 1920x1080 and 3840x2160, --json included. The techniques
// differ by less than a tenth, since the pictures weigh more than the levels: the one that takes more counts.
constexpr std::uint64_t kBytesPerRenderedPixel = 115;
constexpr std::uint64_t kBytesPerComparedPixel = 200;
constexpr std::uint64_t kBytesOfProgramAndScene = 300'000'000;

std::uint64_t pixelsOf(glm::ivec2 size) {
  return static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
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

std::uint64_t physicalMemory() {
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void requireMemory(std::uint64_t needed, std::uint64_t available) {
  if (needed <= available) return;
  throw std::runtime_error(fmt::format(
      "Pictures of that size need about {:.1f} GiB of memory, and this machine has {:.1f} GiB; give "
      "a smaller --size.",
      gibibytes(needed), gibibytes(available)));
}

}  // namespace host
