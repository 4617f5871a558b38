#pragma once

#include <epoxy/gl.h>

#include "host/image/image_file.h"

namespace host {

/// Reads level 0 of a colour or depth texture back, flipped so that rows run top to bottom. Values are as
/// stored: sRGB textures come sRGB-encoded.
FloatImage readTexture(GLuint texture, glm::ivec2 size, int channels);

}  // namespace host
