#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "host/scene/gltf/accessor.h"

namespace host::gltf {

/// Triangles that a primitive of this mode makes of `elements` vertices or indices; none for points and
/// lines.
std::size_t triangleCount(int mode, std::size_t elements);

/// Three vertex numbers for each triangle of a list, strip or fan, each below `vertexCount`. `indices` may be
/// null. Throws std::runtime_error, naming `purpose`, where an index is out of range.
std::vector<std::uint32_t> triangleCorners(int mode, const Accessor* indices, std::size_t vertexCount,
                                           std::string_view purpose);

}  // namespace host::gltf
