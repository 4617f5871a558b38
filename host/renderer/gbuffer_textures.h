#pragma once

#include <epoxy/gl.h>

namespace host {

/// The G-buffer's textures, as any engine would hand them to mres. They stay the renderer's.
struct GBufferTextures {
  GLuint depth = 0;            ///< GL_DEPTH_COMPONENT32F, window depth 0..1, 1 where nothing was drawn
  GLuint albedo = 0;           ///< GL_SRGB8_ALPHA8; alpha is 1 where something was drawn, else 0
  GLuint normal = 0;           ///< shading normal in world space, GL_RGB10_A2, n * 0.5 + 0.5
  GLuint geometricNormal = 0;  ///< interpolated vertex normal before normal mapping, same encoding
  GLuint material = 0;         ///< GL_RGBA8: roughness, metallic, free, free
  GLuint emissive = 0;         ///< GL_R11F_G11F_B10F, linear radiance
};

}  // namespace host
