#pragma once

#include "mres/effect.h"
#include "mres/gl/render_target.h"
#include "mres/gl/uniform_buffer.h"
#include "mres/level/pass_context.h"
#include "mres/settings.h"
#include "shaders/mres/level_params.h"

namespace mres {

/// Finds the edges of an effect that previews its values (the shadow edges of section 3.1 of the paper):
/// where the previews of neighbours differ, or where the preview says that anything may be.
class PreviewPass {
 public:
  /// For effects with a preview; others leave it empty.
  PreviewPass(const gl::ShaderLibrary& library, const EffectDescription& effect);

  /// Lets the effect set up the program once.
  void setUp(Effect& effect);

  /// Needs the effect, depth, normals and the frame's block bound. `geometryEdges` are taken in where they
  /// are given.
  void draw(PassContext& context, float refineThreshold, glm::ivec2 fullSize,
            const gl::Texture2D* geometryEdges);

  /// GL_RG8, ceil(size / 2): red the effect's edges, green the geometry's.
  [[nodiscard]] const gl::Texture2D& edges() const { return edges_.color(); }
  void fill(float value) const;
  [[nodiscard]] std::size_t bytes() const { return bounds_.bytes() + edges_.bytes(); }
  explicit operator bool() const { return static_cast<bool>(preview_); }

 private:
  void ensureTargets(glm::ivec2 fullSize);
  void drawBounds(PassContext& context);

  gl::Program preview_;
  gl::Program difference_;
  gl::Program differenceAndGeometry_;
  bool filtered_ = false;
  bool isSetUp_ = false;
  gl::UniformBuffer<params::LevelParams> levelBlock_;
  gl::RenderTarget bounds_;
  gl::RenderTarget edges_;
};

}  // namespace mres
