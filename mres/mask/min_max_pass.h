#pragma once

#include <array>

#include "mres/gl/render_target.h"
#include "mres/gl/uniform_buffer.h"
#include "mres/level/pass_context.h"
#include "mres/plan/level_plan.h"
#include "mres/settings.h"
#include "shaders/mres/edges_params.h"
#include "shaders/mres/frame_params.h"

namespace mres {

/// Finds geometry's edges by min/max mips (Nichols and Wyman, "Multiresolution Splatting for Indirect
/// Illumination", 2009), the alternative of section 3.1 of the paper: a level is refined where depths or
/// normals in the block that a pixel of the next coarser level stands for are further apart than the
/// thresholds.
class MinMaxPass {
 public:
  explicit MinMaxPass(const gl::ShaderLibrary& library);

  /// Needs depth and normals bound to their units and the frame's block bound.
  void draw(PassContext& context, const MaskSettings& settings, const params::FrameParams& frame,
            const LevelPlan& plan);

  /// Of a planned level but the last: GL_RG8, of the resolution of its mask; red normals, green depth.
  [[nodiscard]] const gl::Texture2D& edges(int level) const { return levels_.at(slot(level)).edges.color(); }
  void fill(float value) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Level {
    gl::RenderTarget ranges;  // of blocks of 2^(level + 1) pixels: depth, least normal, largest normal
    gl::RenderTarget edges;
  };
  static std::size_t slot(int level) { return static_cast<std::size_t>(level); }
  void drawRanges(PassContext& context, int level, glm::ivec2 fullSize);
  void drawEdges(PassContext& context, int level, int coarser, glm::ivec2 fullSize);

  gl::Program lowest_;
  gl::Program reduce_;
  gl::Program edgesProgram_;
  gl::UniformBuffer<params::EdgesParams> params_;
  std::array<Level, kMaxLevels - 1> levels_;
};

}  // namespace mres
