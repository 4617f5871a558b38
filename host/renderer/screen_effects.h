#pragma once

#include <epoxy/gl.h>
#include <glm/glm.hpp>

namespace host {

/// What screen-space effects add to the lighting: textures of the picture's size, 0 for none.
struct ScreenEffects {
  GLuint accessibility = 0;  ///< red 0..1 multiplies the ambient light; unused with `indirect`
  GLuint visibility =
      0;                ///< red 0..1 multiplies the light that casts shadows, in place of the renderer's own
  GLuint indirect = 0;  ///< irradiance / pi times Renderer::exposure(), in place of diffuse ambient light;
                        ///< highlights mirror as large a part of the ambient light as arrives so
};

/// Ambient radiance that comes from straight above and below; in between it is linear in the vertical
/// component of the direction.
struct AmbientLight {
  glm::vec3 above{0.0f};
  glm::vec3 below{0.0f};
};

/// The shadow map, for effects that filter it themselves.
struct ShadowMap {
  GLuint map = 0;  ///< GL_DEPTH_COMPONENT24; 0 if no light casts shadows, or where none of its light is seen
  glm::ivec2 size{0};  ///< texels
  glm::mat4 shadowFromView{
      1.0f};  ///< view space to texture coordinates and window depth, 0..1 after division by w
  glm::vec4 light{
      0.0f};  ///< view space: unit direction to a directional light and 0, or a spot light's position and 1
};

}  // namespace host
