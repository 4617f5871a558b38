#pragma once

#include <cstdint>
#include <span>

#include "host/scene/scene.h"

namespace host::gltf {

/// Decodes PNG, JPEG, WebP and whatever else OpenImageIO recognises to 8-bit RGBA; grey becomes RGB, missing
/// alpha is opaque. Throws std::runtime_error with a sentence.
Image decodeImage(std::span<const std::uint8_t> encoded);

}  // namespace host::gltf
