// The two ways in which a glTF file is stored: plain JSON, and the GLB container of JSON and one binary
// chunk.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "host/scene/gltf/document.h"

namespace host::gltf {

struct Container {
  std::string_view json;
  std::optional<std::span<const std::uint8_t>> binary;  ///< GLB's BIN chunk
};

/// Views into `file`. Throws std::runtime_error on a broken GLB.
Container openContainer(std::span<const std::uint8_t> file);

}  // namespace host::gltf
