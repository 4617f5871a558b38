#include "mres/mask/edge_pass.h"

#include <cmath>
#include <glm/glm.hpp>

namespace mres {
namespace {

/// Unit vectors at an angle a differ by 2 sin(a / 2).
float normalDifference2(float degrees, float decodeScale) {
  const float difference = 2.0f * std::sin(0.5f * glm::radians(degrees)) / decodeScale;
  return difference * difference;
}

bool areSame(const params::EdgesParams& a, const params::EdgesParams& b) {
  return a.normalDifference2 == b.normalDifference2 && a.depthThreshold == b.depthThreshold;
}

}  // namespace

params::EdgesParams edgesParams(const MaskSettings& settings, const params::FrameParams& frame) {
  params::EdgesParams params{};
  params.normalDifference2 = normalDifference2(settings.normalThreshold, frame.normalDecode.x);
  params.depthThreshold = settings.depthThreshold;
  return params;
}

EdgePass::EdgePass(const gl::ShaderLibrary& library)
    : program_(makePassProgram(library, "mres/edges.frag")),
      foldsProgram_(makePassProgram(library, "mres/folds.frag")) {}

bool EdgePass::draw(PassContext& context, const MaskSettings& settings, const params::FrameParams& frame,
                    std::uint64_t frameId) {
  const glm::ivec2 size = levelSize(frame.size, 1);
  const params::EdgesParams thresholds = edgesParams(settings, frame);
  if (target_.size() == size && frameId != 0 && frameId == frame_ && areSame(thresholds, thresholds_))
    return false;
  frame_ = 0;  // until it is drawn
  foldsTowards_ = {};
  const gl::Scope scope(context.profiler, "mres.edges");
  if (target_.size() != size) target_ = gl::RenderTarget(size, {GL_RG8}, 0, "mres.edges");

  params_.upload(thresholds);
  params_.bind(kPassBlock);
  glUseProgram(program_.id());
  target_.bind();
  context.triangle.draw();
  frame_ = frameId;
  thresholds_ = thresholds;
  return true;
}

void EdgePass::drawFolds(PassContext& context, int level, int coarser, glm::ivec2 fullSize) {
  int& towards = foldsTowards_.at(slot(level));
  if (towards == coarser) return;
  const gl::Scope scope(context.profiler, "mres.edges");
  gl::RenderTarget& target = folds_.at(slot(level));
  const glm::ivec2 size = levelSize(fullSize, level + 1);
  if (target.size() != size) target = gl::RenderTarget(size, {GL_R8}, 0, "mres.edges");

  params_.bind(kPassBlock);
  glUseProgram(foldsProgram_.id());
  glUniform1i(foldsProgram_.uniformLocation("texelStride"), 2 << level);
  glUniform1i(foldsProgram_.uniformLocation("coarserStride"), 1 << coarser);
  target.bind();
  context.triangle.draw();
  towards = coarser;
}

void EdgePass::fill(float value) {
  frame_ = 0;
  foldsTowards_ = {};
  target_.fill(value);
  for (const gl::RenderTarget& target : folds_) target.fill(value);
}

std::size_t EdgePass::bytes() const {
  std::size_t sum = target_.bytes();
  for (const gl::RenderTarget& target : folds_) sum += target.bytes();
  return sum;
}

}  // namespace mres
