#pragma once

#include <epoxy/gl.h>
#include <glm/glm.hpp>

namespace host {

/// What screen-space effects add to the lighting: textures of the picture's size, 0 for none.
struct ScreenEffects {
  GLuint accessibility = 0;  ///< red 0..1 multiplies the ambient light
  GLuint sunVisibility = 0;  ///< red 0..1 multiplies the sun's light, in place of the renderer's own shadows
  GLuint indirect = 0;       ///< exposed irradiance / pi, in place of the diffuse part of the ambient light
};

/// Ambient radiance from straight above and below; in between it is interpolated by the vertical direction.
struct AmbientLight {
  glm::vec3 above{0.0f};
  glm::vec3 below{0.0f};
};

/// The sun's shadow map, for effects that filter it themselves.
struct SunShadow {
  GLuint map = 0;      ///< GL_DEPTH_COMPONENT24; 0 without a sun, or where none of its light is seen
  glm::ivec2 size{0};  ///< texels
  glm::mat4 shadowFromView{1.0f};  ///< view space to texture coordinates and window depth, 0..1
  glm::vec3 directionToSun{0.0f};  ///< view space, unit length
};

}  // namespace host
