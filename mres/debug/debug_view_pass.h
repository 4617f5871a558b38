#pragma once

#include "mres/gl/render_target.h"
#include "mres/level/pass_context.h"
#include "mres/mask/zone_pass.h"
#include "mres/plan/level_plan.h"

namespace mres {

/// Draws pictures of the decision that the last frame made.
class DebugViewPass {
 public:
  explicit DebugViewPass(const gl::ShaderLibrary& library);

  /// `edges` is null where the frame needed none: the picture is black.
  const gl::Texture2D& drawEdges(PassContext& context, const gl::Texture2D* edges, glm::ivec2 fullSize);
  const gl::Texture2D& drawLevels(PassContext& context, const ZonePass& zones, const LevelPlan& plan);

 private:
  void draw(PassContext& context, const gl::Program& program, glm::ivec2 fullSize);

  gl::Program edges_;
  gl::Program levels_;
  gl::RenderTarget target_;
};

}  // namespace mres
