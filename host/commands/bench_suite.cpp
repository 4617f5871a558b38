#include "host/commands/bench_suite.h"

#include <fmt/format.h>

#include "host/commands/parse.h"
#include "host/commands/usage_error.h"

namespace host {
namespace {

constexpr glm::ivec2 k720p{1280, 720};
constexpr glm::ivec2 k1080p{1920, 1080};
constexpr glm::ivec2 k1440p{2560, 1440};
constexpr glm::ivec2 k4k{3840, 2160};
constexpr int kSamples = 64;  // the paper's setting for SSAO

/// Two cameras of every built-in scene, and for one view how size and samples change the gain (the paper's
/// figures 5 and 6 in small).
std::vector<BenchCase> quickSuite() {
  return {
      {"hall", 0, k1080p, kSamples, true},
      {"hall", 0, k720p, kSamples},
      {"hall", 0, k1440p, kSamples},
      {"hall", 0, k4k, kSamples},
      {"hall", 0, k1080p, 16},
      {"hall", 0, k1080p, 128},
      {"hall", 3, k1080p, kSamples},
      {"office", 0, k1080p, kSamples, true},
      {"office", 3, k1080p, kSamples},
      {"breakfast", 0, k1080p, kSamples, true},
      {"breakfast", 3, k1080p, kSamples},
  };
}

/// What the tests run: a campaign of seconds that has a plot and a picture. Its numbers mean nothing, so
/// users are not offered it.
constexpr const char* kSmokeSuite = "smoke";

std::vector<BenchCase> smokeSuite() {
  return {{"office", 0, {64, 36}, 4, true}, {"office", 0, {32, 18}, 4}};
}

}  // namespace

const std::vector<std::string>& suiteNames() {
  static const std::vector<std::string> kNames{"quick"};
  return kNames;
}

std::vector<BenchCase> suiteCases(const std::string& suite) {
  if (suite == suiteNames().front()) return quickSuite();
  if (suite == kSmokeSuite) return smokeSuite();
  throw UsageError(fmt::format("There is no suite '{}'{}", suite, suggestion(suite, suiteNames())));
}

std::string nameOf(const BenchCase& benchCase) {
  return fmt::format("{} {} {}x{} {} samples", benchCase.scene, benchCase.camera, benchCase.size.x,
                     benchCase.size.y, benchCase.samples);
}

}  // namespace host
