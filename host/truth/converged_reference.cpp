#include "host/truth/converged_reference.h"

#include <fmt/format.h>
#include <vector>

#include "host/renderer/read_texture.h"
#include "host/truth/grid_effect.h"

namespace host {
namespace {

PixelGrid gridOf(glm::ivec2 size) {
  return {.pictureSize = size, .tile = 4, .stride = kConvergedStride};
}

mres::MultiResolution makeMultiResolution(const std::string& shaderDirectory) {
  mres::MultiResolution multiResolution({.shaderDirectory = shaderDirectory});
  multiResolution.settings().technique = mres::Technique::full;
  return multiResolution;
}

void add(const FloatImage& values, std::vector<double>& sums) {
  sums.resize(values.pixels.size());
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += values.pixels[i];
}

}  // namespace

ConvergedReference::ConvergedReference(const std::string& shaderDirectory)
    : multiResolution_(makeMultiResolution(shaderDirectory)) {}

Truth ConvergedReference::render(const ConvergingPasses& passes, const mres::Frame& frame,
                                 const WorkObserver& observe) {
  Truth truth{"converged", "samples", passes.passes * passes.samples, gridOf(frame.size), {}};
  std::vector<double> sums;
  for (int pass = 0; pass < passes.passes; ++pass) {
    observe(static_cast<double>(pass) / passes.passes,
            fmt::format("converged reference, pass {} of {}", pass + 1, passes.passes));
    GridEffect effect(passes.effect(pass), truth.grid);
    const GLuint texture = multiResolution_.render(effect, frame);
    truth.values = valuesAt(truth.grid, readTexture(texture, frame.size, effect.description().channels));
    add(truth.values, sums);
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    truth.values.pixels[i] = static_cast<float>(sums[i] / passes.passes);
  return truth;
}

}  // namespace host
