#include "tests/golden/golden_image.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "host/measure/error_metrics.h"

namespace mres::test {
namespace {

namespace fs = std::filesystem;

double failingShare(const host::FloatImage& picture, const host::FloatImage& golden, float perChannel) {
  const auto channels = static_cast<std::size_t>(picture.channels);
  std::size_t failing = 0;
  for (std::size_t pixel = 0; pixel < picture.pixels.size(); pixel += channels) {
    bool fails = false;
    for (std::size_t channel = pixel; channel < pixel + channels; ++channel) {
      fails |= !(std::abs(picture.pixels[channel] - golden.pixels[channel]) <= perChannel);
    }
    failing += fails ? 1 : 0;
  }
  return static_cast<double>(failing * channels) / static_cast<double>(picture.pixels.size());
}

void keepForInspection(const host::FloatImage& picture, const host::FloatImage& golden,
                       const std::string& name) {
  const fs::path folder = MRES_GOLDEN_OUTPUT;
  fs::create_directories(folder);
  host::writeImage(folder / (name + ".png"), picture);
  host::writeImage(folder / (name + "_difference_x8.png"), host::differenceImage(picture, golden, 8.0f));
}

}  // namespace

testing::AssertionResult matchesGolden(const host::FloatImage& picture, const std::string& name,
                                       const GoldenTolerance& tolerance) {
  const fs::path path = fs::path(MRES_GOLDEN_DIRECTORY) / (name + ".png");
  if (std::getenv("MRES_UPDATE_GOLDEN") != nullptr) {
    fs::create_directories(path.parent_path());
    host::writeImage(path, picture);
    return testing::AssertionSuccess();
  }
  if (!fs::exists(path)) {
    return testing::AssertionFailure() << name << " has no golden picture; MRES_UPDATE_GOLDEN=1 makes it";
  }
  const host::FloatImage golden = host::readImage(path);
  if (golden.size != picture.size || golden.channels != picture.channels) {
    return testing::AssertionFailure()
           << name << " has another size or number of channels than its golden picture";
  }
  const double share = failingShare(picture, golden, tolerance.perChannel);
  if (share <= tolerance.failingShare) return testing::AssertionSuccess();
  keepForInspection(picture, golden, name);
  return testing::AssertionFailure() << share * 100.0 << " % of " << name
                                     << " differ from the golden picture; see " << MRES_GOLDEN_OUTPUT;
}

}  // namespace mres::test
