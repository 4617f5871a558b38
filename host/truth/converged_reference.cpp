#include "host/truth/converged_reference.h"

#include <cstdint>
#include <fmt/format.h>
#include <utility>
#include <vector>

#include "host/renderer/read_texture.h"
#include "host/truth/quarter_effect.h"

namespace host {
namespace {

mres::MultiResolution makeMultiResolution(const std::string& shaderDirectory) {
  mres::MultiResolution multiResolution({.shaderDirectory = shaderDirectory});
  multiResolution.settings().mask.combination = mres::kCombineByMinimum;
  return multiResolution;
}

mres::gl::Texture2D makeZero() {
  constexpr std::uint8_t kZero = 0;
  return {GL_R8, {1, 1}, "host.truth.importance", 1, &kZero};
}

/// The coarsest level covers the screen, and nothing else was evaluated.
PixelGrid gridOf(const mres::Report& report, glm::ivec2 size) {
  return {size, 1 << report.levels.back().index};
}

void add(const FloatImage& values, std::vector<double>& sums) {
  sums.resize(values.pixels.size());
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += values.pixels[i];
}

}  // namespace

ConvergedReference::ConvergedReference(const std::string& shaderDirectory)
    : multiResolution_(makeMultiResolution(shaderDirectory)), nothingMatters_(makeZero()) {}

Truth ConvergedReference::render(const ConvergingPasses& passes, const mres::Frame& frame,
                                 const WorkObserver& observe) {
  mres::Frame quarterFrame = frame;
  quarterFrame.importance = nothingMatters_.id();
  Truth truth{"converged", "samples", passes.passes * passes.samples, {}, {}};
  std::vector<double> sums;
  for (int pass = 0; pass < passes.passes; ++pass) {
    observe(static_cast<double>(pass) / passes.passes,
            fmt::format("converged reference, pass {} of {}", pass + 1, passes.passes));
    QuarterEffect effect(passes.effect(pass));
    const GLuint texture = multiResolution_.render(effect, quarterFrame);
    truth.grid = gridOf(multiResolution_.report(), frame.size);
    truth.values = valuesAt(truth.grid, readTexture(texture, frame.size, effect.description().channels));
    add(truth.values, sums);
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    truth.values.pixels[i] = static_cast<float>(sums[i] / passes.passes);
  return truth;
}

}  // namespace host
