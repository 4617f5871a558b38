#include "mres/level/frame_textures.h"

#include <algorithm>
#include <cmath>

#include "mres/gl/bound_texture.h"

namespace mres {

// Steps of fixed-point depth are constant, those of floating-point depth at most so large a share of it.
glm::vec2 depthRounding(const DepthFormat& format) {
  constexpr int kFloatBits = 24;  // what shaders see of any format
  return format.floatingPoint ? glm::vec2(0.0f, std::ldexp(1.0f, 1 - kFloatBits))
                              : glm::vec2(std::ldexp(1.0f, -std::min(format.bits, kFloatBits)), 0.0f);
}

DepthFormat bindFrameTextures(const PassContext& context, const Frame& frame) {
  constexpr const char* kSize = "Frame::size is";
  // The pass that reads the importance binds it anew: its unit is that of other textures, too.
  if (frame.importance != 0)
    gl::BoundTexture("Frame::importance", kMaskUnit, frame.importance, context.linear).requireChannels(1);
  const gl::BoundTexture normals("Frame::normals", kNormalUnit, frame.normals, context.nearest);
  normals.requireSize(frame.size, kSize);
  normals.requireChannels(3);
  const gl::BoundTexture depth("Frame::depth", kDepthUnit, frame.depth, context.nearest);
  depth.requireSize(frame.size, kSize);
  depth.requireDepth();
  return {.bits = depth.parameter(GL_TEXTURE_DEPTH_SIZE),
          .floatingPoint = depth.parameter(GL_TEXTURE_DEPTH_TYPE) == GL_FLOAT};
}

}  // namespace mres
