// Where the renderer's uniform blocks and textures are bound.
#pragma once

#include <epoxy/gl.h>

namespace host::bindings {

// Uniform blocks.
inline constexpr GLuint kView = 0;
inline constexpr GLuint kMaterial = 1;
inline constexpr GLuint kEnvironment = 2;
inline constexpr GLuint kShadow = 3;
inline constexpr GLuint kLights = 4;
inline constexpr GLuint kToneMap = 5;

// Texture units: four of the material, one of the shadow map, then what a full-screen pass reads.
inline constexpr GLint kBaseColor = 0;
inline constexpr GLint kMetallicRoughness = 1;
inline constexpr GLint kNormal = 2;
inline constexpr GLint kEmissive = 3;
inline constexpr GLint kShadowMap = 4;
inline constexpr GLint kFirstScreenTexture = 5;

}  // namespace host::bindings
