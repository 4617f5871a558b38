#pragma once

#include "mres/gl/render_target.h"
#include "mres/level/pass_context.h"
#include "mres/mask/zone_pass.h"
#include "mres/plan/level_plan.h"

namespace mres {

/// The edge images that a frame made its masks of; null for those that it needed not.
struct EdgeImages {
  const gl::Texture2D* geometry = nullptr;
  const gl::Texture2D* effect = nullptr;
  bool areShared = false;  ///< the geometry's were those of another effect of the frame
};

/// Draws pictures of the decision that the last frame made.
class DebugViewPass {
 public:
  explicit DebugViewPass(const gl::ShaderLibrary& library);

  /// Red normals, green depth, blue the effect's own edges; black where an edge image is null, not needed by
  /// the frame.
  const gl::Texture2D& drawEdges(PassContext& context, const EdgeImages& edges, glm::ivec2 fullSize);
  const gl::Texture2D& drawLevels(PassContext& context, const ZonePass& zones, const LevelPlan& plan);

 private:
  void draw(PassContext& context, const gl::Program& program, glm::ivec2 fullSize);

  gl::Program edges_;
  gl::Program levels_;
  gl::RenderTarget target_;
};

}  // namespace mres
