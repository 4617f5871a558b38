#include "mres/mask/edge_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "mres/plan/level_plan.h"

namespace mres {
namespace {

/// Unit vectors at an angle a differ by 2 sin(a / 2).
float normalDifference2(float degrees, float decodeScale) {
  const float difference = 2.0f * std::sin(0.5f * glm::radians(degrees)) / decodeScale;
  return difference * difference;
}

/// The second difference of three rounded depths is off by two steps at most; rasterisers add as much again.
/// Steps of fixed-point depth are constant, those of floating-point depth proportional to it.
glm::vec2 depthRounding(const DepthFormat& format) {
  constexpr int kFloatBits = 24;
  return format.floatingPoint ? glm::vec2(0.0f, std::ldexp(8.0f, -kFloatBits))
                              : glm::vec2(std::ldexp(4.0f, -std::min(format.bits, kFloatBits)), 0.0f);
}

}  // namespace

params::EdgesParams edgesParams(const MaskSettings& settings, const params::FrameParams& frame,
                                const DepthFormat& depth) {
  const glm::vec4& l = frame.linearise;
  return {.depthSlope = {std::abs(l.y * l.z - l.x * l.w), l.z, l.w, 0.0f},
          .normalDifference2 = normalDifference2(settings.normalThreshold, frame.normalDecode.x),
          .depthThreshold = settings.depthThreshold,
          .depthRounding = depthRounding(depth)};
}

EdgePass::EdgePass(const gl::ShaderLibrary& library)
    : program_(makePassProgram(library, "mres/edges.frag")) {}

void EdgePass::draw(PassContext& context, const MaskSettings& settings, const params::FrameParams& frame,
                    const DepthFormat& depth) {
  const gl::Scope scope(context.profiler, "mres.edges");
  const glm::ivec2 size = levelSize(frame.size, 1);
  if (target_.size() != size) target_ = gl::RenderTarget(size, {GL_RG8}, 0, "mres.edges");

  params_.upload(edgesParams(settings, frame, depth));
  params_.bind(kPassBlock);
  glUseProgram(program_.id());
  target_.bind();
  context.triangle.draw();
}

}  // namespace mres
