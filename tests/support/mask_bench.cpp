#include "tests/support/mask_bench.h"

#include <algorithm>

#include "mres/level/frame_params.h"
#include "mres/level/frame_textures.h"
#include "tests/support/gl_test.h"
#include "tests/support/glsl_function.h"

namespace mres::test {
namespace {

PassContext makeContext() {
  PassContext context;
  context.library = shaderLibrary();
  return context;
}

}  // namespace

Image readImage(const gl::Texture2D& texture, int channels) {
  return {texture.size(), channels, readPixels(texture.id(), texture.size(), channels)};
}

double bilinear(const Image& image, glm::dvec2 place) {
  const glm::dvec2 corner = glm::floor(place - 0.5);
  const glm::dvec2 weight = place - 0.5 - corner;
  const auto at = [&](int x, int y) {
    const glm::ivec2 texel = glm::clamp(glm::ivec2(corner) + glm::ivec2(x, y), glm::ivec2(0), image.size - 1);
    return static_cast<double>(image.at(texel));
  };
  return (at(0, 0) * (1.0 - weight.x) + at(1, 0) * weight.x) * (1.0 - weight.y) +
         (at(0, 1) * (1.0 - weight.x) + at(1, 1) * weight.x) * weight.y;
}

double largestIn(const Image& image, glm::dvec2 low, glm::dvec2 high, int samplesPerAxis) {
  double largest = 0.0;
  for (int i = 0; i < samplesPerAxis * samplesPerAxis; ++i) {
    const glm::dvec2 share = glm::dvec2(i % samplesPerAxis, i / samplesPerAxis) / (samplesPerAxis - 1.0);
    largest = std::max(largest, bilinear(image, glm::mix(low, high, share)));
  }
  return largest;
}

MaskBench::MaskBench() : context_(makeContext()), edgePass_(context_.library), maskPass_(context_.library) {}

Image MaskBench::edges(const Frame& frame, const MaskSettings& settings) {
  frame_ = frame;
  params::FrameParams params = frameParams(frame);
  params.depthRounding = depthRounding(bindFrameTextures(context_, frame));
  frameBlock_.upload(params);
  frameBlock_.bind(kFrameBlock);
  edgePass_.draw(context_, settings, params, frame.id);
  return readImage(edgePass_.edges(), 2);
}

Image MaskBench::folds(int level, int coarser, glm::ivec2 fullSize) {
  static_cast<void>(bindFrameTextures(context_, frame_));  // reading a picture binds another
  edgePass_.drawFolds(context_, level, coarser, fullSize);
  return readImage(edgePass_.folds(level), 1);
}

std::vector<Image> MaskBench::masks(const gl::Texture2D& edges, const LevelPlan& plan) {
  return masksOf({.edges = &edges}, plan);
}

std::vector<Image> MaskBench::edgesWithFolds(const LevelPlan& plan) {
  MaskSources sources{.edges = &edgePass_.edges()};
  for (std::size_t i = 1; i + 1 < plan.levels.size(); ++i) {
    const int level = plan.levels[i].index;
    static_cast<void>(folds(level, plan.levels[i + 1].index, plan.levels.front().size));
    sources.joined.at(static_cast<std::size_t>(level)) = &edgePass_.folds(level);
  }
  maskPass_.drawEdges(context_, sources, plan);
  std::vector<Image> images;
  for (std::size_t i = 0; i + 1 < plan.levels.size(); ++i)
    images.push_back(readImage(maskPass_.edges(plan.levels[i].index), 2));
  return images;
}

std::vector<Image> MaskBench::masksOf(const MaskSources& sources, const LevelPlan& plan) {
  maskPass_.drawEdges(context_, sources, plan);
  maskPass_.drawBlurred(context_, plan);
  std::vector<Image> images;
  for (std::size_t i = 0; i + 1 < plan.levels.size(); ++i) {
    images.push_back(readImage(maskPass_.blurred(plan.levels[i].index), 1));
  }
  return images;
}

}  // namespace mres::test
