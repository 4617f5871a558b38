#include "host/bench/pareto_suite.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "host/measure/picture_settings.h"
#include "host/measure/techniques.h"
#include "mres/settings.h"

namespace host {
namespace {

constexpr glm::ivec2 k720p{1280, 720};
constexpr glm::ivec2 k1080p{1920, 1080};
constexpr glm::ivec2 k4k{3840, 2160};

constexpr int kFlickerFrames = 3;
constexpr int kThoroughCameras = 8;

/// How widely a technique is measured; each rank has what the ones before it have.
enum class Rank {
  thorough,    ///< where everything is
  once,        ///< at 1920x1080
  small,       ///< at 1280x720
  everywhere,  ///< at 3840x2160
  checked      ///< against truth and for flicker, at 1920x1080
};

struct Rival {
  const char* technique;
  double samples;  ///< for each of the reference
  float errorBudget;
  Rank rank;
};

constexpr float kBudget = mres::MaskSettings{}.errorBudget;

// Every number of samples has its pattern: an eighth of 196 is 24, of 228 it is 28. Twice and four times as
// many cost what they cost and tell what the reference itself errs by.
constexpr std::array kRivals{Rival{kFullTechnique, 0.125, kBudget, Rank::small},
                             Rival{kFullTechnique, 0.25, kBudget, Rank::everywhere},
                             Rival{kFullTechnique, 0.5, kBudget, Rank::everywhere},
                             Rival{kFullTechnique, 2.0, kBudget, Rank::once},
                             Rival{kFullTechnique, 4.0, kBudget, Rank::thorough},
                             Rival{"half-bilinear", 1.0, kBudget, Rank::small},
                             Rival{"half-joint", 1.0, kBudget, Rank::checked},
                             Rival{"quarter-bilinear", 1.0, kBudget, Rank::small},
                             Rival{"quarter-joint", 1.0, kBudget, Rank::checked},
                             Rival{"checkerboard", 1.0, kBudget, Rank::checked},
                             Rival{"interleaved", 1.0, kBudget, Rank::small},
                             Rival{kAdaptiveTilesTechnique, 1.0, 0.005f, Rank::thorough},
                             Rival{kAdaptiveTilesTechnique, 1.0, kBudget, Rank::checked},
                             Rival{kAdaptiveTilesTechnique, 1.0, 0.02f, Rank::once},
                             Rival{kPaperTechnique, 1.0, kBudget, Rank::everywhere},
                             Rival{kMinMaxTechnique, 1.0, kBudget, Rank::small},
                             Rival{kMresTechnique, 1.0, 0.0025f, Rank::once},
                             Rival{kMresTechnique, 1.0, 0.005f, Rank::everywhere},
                             Rival{kMresTechnique, 1.0, kBudget, Rank::checked},
                             Rival{kMresTechnique, 1.0, 0.02f, Rank::everywhere},
                             Rival{kMresTechnique, 1.0, 0.04f, Rank::once}};

/// Where soft shadows are split their shadows' edges say: min/max mips of the geometry are not asked.
bool isOfUse(const Rival& rival, const std::string& effect) {
  return rival.technique != std::string(kMinMaxTechnique) || effect != kSoftShadowEffect;
}

Rank rankFor(glm::ivec2 size) {
  if (size == k4k) return Rank::everywhere;
  return size == k720p ? Rank::small : Rank::once;
}

/// As the paper's evaluation has them.
int samplesOf(const std::string& effect, glm::ivec2 size) {
  if (effect == kSoftShadowEffect) return 196;
  if (effect == kSsgiEffect) return size == k4k ? 288 : 228;
  return 64;
}

BenchCase caseOf(const Rival& rival, const BenchCase& view) {
  BenchCase benchCase = view;
  const bool isChecked = view.size == k1080p && view.camera == 0 && rival.rank == Rank::checked;
  const bool isMres = rival.technique == std::string(kMresTechnique) && rival.errorBudget == kBudget;
  benchCase.samples = static_cast<int>(rival.samples * view.referenceSamples);
  benchCase.technique = rival.technique;
  benchCase.errorBudget = rival.errorBudget;
  benchCase.truth = isChecked;
  benchCase.frames = isChecked ? kFlickerFrames : 0;
  benchCase.pictures = isChecked && isMres;
  return benchCase;
}

/// By each technique in all sizes: its shaders serve them all.
std::vector<BenchCase> casesOf(const BenchScene& scene, const std::string& effect, bool thorough) {
  std::vector<BenchCase> cases;
  for (const Rival& rival : kRivals) {
    if (!isOfUse(rival, effect)) continue;
    for (const glm::ivec2 size : {k720p, k1080p, k4k})
      for (int camera = 0; camera < (thorough ? kThoroughCameras : 1); ++camera) {
        if (!thorough && rival.rank < rankFor(size)) continue;
        const BenchCase view{.scene = scene,
                             .effect = effect,
                             .size = size,
                             .camera = camera,
                             .referenceSamples = samplesOf(effect, size),
                             .stages = false};
        cases.push_back(caseOf(rival, view));
      }
  }
  return cases;
}

}  // namespace

std::vector<BenchCase> paretoSmokeCases(const BenchScene& scene) {
  const BenchCase mres{.scene = scene,
                       .effect = kSsaoEffect,
                       .samples = 8,
                       .size = {64, 36},
                       .referenceSamples = 8,
                       .stages = false};
  std::vector<BenchCase> cases(4, mres);
  cases[0].truth = true;
  cases[0].frames = 2;
  cases[1].errorBudget = 0.08f;
  cases[2].technique = "half-joint";
  cases[3].technique = kFullTechnique;
  cases[3].samples = 2;
  return cases;
}

std::vector<BenchCase> paretoCases(const BenchScene& scene, bool thorough) {
  std::vector<BenchCase> cases;
  for (const std::string& effect : effectNames())
    std::ranges::copy(casesOf(scene, effect, thorough), std::back_inserter(cases));
  return cases;
}

}  // namespace host
