#pragma once

#include <vector>

#include "mres/frame.h"
#include "mres/gl/uniform_buffer.h"
#include "mres/level/pass_context.h"
#include "mres/mask/edge_pass.h"
#include "mres/mask/mask_pass.h"
#include "mres/plan/level_plan.h"
#include "tests/support/pictures.h"

namespace mres::test {

Image readImage(const gl::Texture2D& texture, int channels);

/// Bilinear sampling at a place in texels (centres at + 0.5), clamped to the edge.
double bilinear(const Image& image, glm::dvec2 place);

/// The largest of n x n bilinear samples spread evenly over a rectangle, corners included.
double largestIn(const Image& image, glm::dvec2 low, glm::dvec2 high, int samplesPerAxis);

/// Runs the mask steps of a frame one by one.
class MaskBench {
 public:
  MaskBench();

  /// The edge image: channel 0 normals, channel 1 depth.
  Image edges(const Frame& frame, const MaskSettings& settings = {});

  /// After edges(): where normals turn between the pixels of a level that is coarser than `level`.
  Image folds(int level, int coarser, glm::ivec2 fullSize);

  /// The masks of a plan's levels but the last, from an edge image in a texture or from the last edges().
  std::vector<Image> masks(const gl::Texture2D& edges, const LevelPlan& plan);
  std::vector<Image> masks(const LevelPlan& plan) { return masks(edgePass_.edges(), plan); }
  /// The edges of a plan's levels but the last, from the last edges() and the folds of each level: channel 0
  /// normals, channel 1 depth.
  std::vector<Image> edgesWithFolds(const LevelPlan& plan);
  /// Of the last masks(), and the edges that it was made of.
  [[nodiscard]] const gl::Texture2D& mask(int level) const { return maskPass_.blurred(level); }
  [[nodiscard]] const gl::Texture2D& edges(int level) const { return maskPass_.edges(level); }

 private:
  std::vector<Image> masksOf(const MaskSources& sources, const LevelPlan& plan);

  PassContext context_;
  Frame frame_;  // of the last edges()
  gl::UniformBuffer<params::FrameParams> frameBlock_;
  EdgePass edgePass_;
  MaskPass maskPass_;
};

}  // namespace mres::test
