#pragma once

#include "mres/frame.h"
#include "mres/level/pass_context.h"

namespace mres {

/// How a depth texture stores window depth.
struct DepthFormat {
  int bits = 24;
  bool floatingPoint = false;
};

/// A step of the format: .x + .y * window depth (FrameParams::depthRounding).
glm::vec2 depthRounding(const DepthFormat& format);

/// Binds a frame's textures to their units. Throws std::invalid_argument with a sentence, and leaves no
/// OpenGL error behind, if one is not what frame.h asks for.
DepthFormat bindFrameTextures(const PassContext& context, const Frame& frame);

}  // namespace mres
