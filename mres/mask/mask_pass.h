#pragma once

#include <array>

#include "mres/gl/render_target.h"
#include "mres/gl/uniform_buffer.h"
#include "mres/level/pass_context.h"
#include "mres/plan/level_plan.h"
#include "shaders/mres/mask_blur_params.h"

namespace mres {

/// The Gaussian of a mask: variance in texels^2, taps whose weight an eight-bit mask would round to zero left
/// out.
params::MaskBlurParams gaussian(float variance);

/// Distance in texels from an edge up to which the mask that a Gaussian makes of it is surely above zero.
int solidRadius(const params::MaskBlurParams& kernel);

/// What the masks are made of.
struct MaskSources {
  const gl::Texture2D* edges = nullptr;  ///< at the resolution of level 1
  /// By level, at the resolution of its mask: edges that show only there; null for none. Level 0 has `edges`.
  std::array<const gl::Texture2D*, kMaxLevels - 1> joined{};
};

/// Turns the edge image into one mask per level: down-sampled and, for the paper's technique, blurred by the
/// level's variance. The mask of level i has the resolution of level i + 1 (a texel is a 2x2 quad of the
/// level's pixels), and is above zero wherever the mask of a finer level is.
class MaskPass {
 public:
  explicit MaskPass(const gl::ShaderLibrary& library);

  /// Down-samples the edges for all levels of the plan but the last, which needs no mask.
  void drawEdges(PassContext& context, const MaskSources& sources, const LevelPlan& plan);
  /// After drawEdges(): blurs them.
  void drawBlurred(PassContext& context, const LevelPlan& plan);

  /// Of a level that drawEdges() was given: GL_RG8, red normals, green depth; of the finest, the source.
  [[nodiscard]] const gl::Texture2D& edges(int level) const { return *edges_.at(slot(level)); }
  /// Of a level that drawBlurred() was given: GL_R8.
  [[nodiscard]] const gl::Texture2D& blurred(int level) const { return levels_.at(slot(level)).mask.color(); }
  void fill(float value) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Level {
    gl::RenderTarget edges;  // the edge image at the mask's resolution; level 0 uses the detector's own
    gl::RenderTarget blurredAlongX;
    gl::RenderTarget mask;
    params::MaskBlurParams kernel{};
    std::array<gl::UniformBuffer<params::MaskBlurParams>, 2> kernelBlocks;  // along x, along y
    float variance = -1.0f;  // of the kernel in pixels^2; there is none yet
    int reach = 0;           // texels from an edge up to which the mask may be above zero
  };
  static std::size_t slot(int level) { return static_cast<std::size_t>(level); }
  const gl::Texture2D& edgesOf(PassContext& context, int level, const gl::Texture2D& finerEdges,
                               const gl::Texture2D* joined, glm::ivec2 fullSize);
  static void setKernel(Level& level, float variance, int finerRatio);
  void blur(PassContext& context, const gl::Texture2D& source, Level& level, const Level* finer);

  gl::Program downsampleProgram_;
  gl::Program downsampleJoinProgram_;
  gl::Program blurProgram_;
  gl::Program blurJoinProgram_;
  std::array<Level, kMaxLevels - 1> levels_;
  std::array<const gl::Texture2D*, kMaxLevels - 1> edges_{};  // of this frame
};

}  // namespace mres
