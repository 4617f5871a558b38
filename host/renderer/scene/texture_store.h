#pragma once

#include <map>
#include <tuple>
#include <utility>

#include "host/scene/scene.h"
#include "mres/gl/texture.h"

namespace host {

/// The scene's images as textures with mip levels, and the samplers that its materials ask for.
class TextureStore {
 public:
  enum class Content { color, data };  ///< sRGB-encoded colour, or linear numbers

  struct Binding {
    GLuint texture = 0;
    GLuint sampler = 0;
  };

  TextureStore();

  /// What a material's use of a texture binds; one white texel where it uses none. Uploads an image when it
  /// is first asked for.
  Binding binding(const Scene& scene, const TextureUse& use, Content content);

  /// One white texel.
  [[nodiscard]] GLuint white() const { return white_.id(); }
  [[nodiscard]] std::size_t bytes() const;

 private:
  GLuint textureOf(const Scene& scene, int image, Content content);
  GLuint samplerOf(const Texture& texture);

  mres::gl::Texture2D white_;
  mres::gl::SamplerName nearest_;
  std::map<std::pair<int, Content>, mres::gl::Texture2D> textures_;
  std::map<std::tuple<Wrap, Wrap, bool>, mres::gl::SamplerName> samplers_;
};

}  // namespace host
