#pragma once

#include <cstddef>
#include <glm/glm.hpp>

#include "mres/gl/object.h"

namespace mres::gl {

/// What glTexImage2D needs to know of a sized internal format, and what a texel costs.
struct FormatInfo {
  GLenum format;  ///< e.g. GL_RED
  GLenum type;    ///< e.g. GL_HALF_FLOAT
  int bytesPerTexel;
};

/// Throws std::invalid_argument for formats that this project does not use.
FormatInfo formatInfo(GLenum internalFormat);

/// A two-dimensional texture of ours. Sampling parameters belong to sampler objects.
class Texture2D {
 public:
  Texture2D() = default;

  /// Allocates `levels` mip levels, each floor(size / 2^level) but at least 1. `pixels` may fill level 0, in
  /// the layout of formatInfo(internalFormat), rows without padding. Leaves the bindings as they are, so that
  /// a target made in the middle of a frame does not take a texture away from a pass.
  Texture2D(GLenum internalFormat, glm::ivec2 size, const char* label, int levels = 1,
            const void* pixels = nullptr);

  [[nodiscard]] GLuint id() const { return name_.id(); }
  [[nodiscard]] glm::ivec2 size() const { return size_; }
  [[nodiscard]] int levels() const { return levels_; }
  [[nodiscard]] GLenum internalFormat() const { return internalFormat_; }
  [[nodiscard]] std::size_t bytes() const;
  explicit operator bool() const { return static_cast<bool>(name_); }

 private:
  TextureName name_;
  GLenum internalFormat_ = 0;
  glm::ivec2 size_{0};
  int levels_ = 0;
};

enum class Filter {
  nearest,     ///< level 0 only
  nearestMip,  ///< the nearest texel of the nearest mip
  linear       ///< level 0 only
};

/// A sampler that clamps to the edge.
SamplerName makeSampler(Filter filter);

/// Binds a texture and a sampler object to a unit, whatever the texture's own parameters are.
void bindTexture(GLuint unit, GLuint texture, const SamplerName& sampler);

}  // namespace mres::gl
