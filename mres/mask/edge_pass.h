#pragma once

#include <array>
#include <cstdint>

#include "mres/gl/render_target.h"
#include "mres/gl/uniform_buffer.h"
#include "mres/level/pass_context.h"
#include "mres/plan/level_plan.h"
#include "mres/settings.h"
#include "shaders/mres/edges_params.h"
#include "shaders/mres/frame_params.h"

namespace mres {

/// The thresholds as the shaders have them.
params::EdgesParams edgesParams(const MaskSettings& settings, const params::FrameParams& frame);

/// Finds the geometry edges of a frame: red normals, green depth, at half resolution (section 3.1 of the
/// paper), and folds, which show at the scale of coarser levels alone.
class EdgePass {
 public:
  explicit EdgePass(const gl::ShaderLibrary& library);

  /// Needs depth and normals bound to their units and the frame's block bound. Returns false, and draws
  /// nothing, if it has the edges of this frame (Frame::id) by these thresholds.
  bool draw(PassContext& context, const MaskSettings& settings, const params::FrameParams& frame,
            std::uint64_t frameId);

  /// After draw(): where normals turn between the pixels of `coarser`, the next coarser level of the plan,
  /// unless that was drawn since.
  void drawFolds(PassContext& context, int level, int coarser, glm::ivec2 fullSize);

  /// GL_RG8, ceil(size / 2).
  [[nodiscard]] const gl::Texture2D& edges() const { return target_.color(); }
  /// GL_R8, the size of level + 1; from drawFolds().
  [[nodiscard]] const gl::Texture2D& folds(int level) const { return folds_.at(slot(level)).color(); }
  /// Binds what counts as an edge, as of the last draw().
  void bindParams() const { params_.bind(kPassBlock); }

  void fill(float value);
  [[nodiscard]] std::size_t bytes() const;

 private:
  static std::size_t slot(int level) { return static_cast<std::size_t>(level); }

  gl::Program program_;
  gl::Program foldsProgram_;
  gl::UniformBuffer<params::EdgesParams> params_;
  gl::RenderTarget target_;
  std::array<gl::RenderTarget, kMaxLevels - 1> folds_;
  std::uint64_t frame_ = 0;  // that they are of
  params::EdgesParams thresholds_{};
  std::array<int, kMaxLevels - 1> foldsTowards_{};  // the coarser level; 0: not drawn
};

}  // namespace mres
