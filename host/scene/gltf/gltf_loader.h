#pragma once

#include <filesystem>

#include "host/scene/scene.h"

namespace host {

/// Reads a glTF 2.0 file (.gltf with its buffers and images, or .glb). Everything is validated before it is
/// used. Throws std::runtime_error with one sentence naming the file, what is wrong, and what to do. What the
/// host does not support but can live without (skins, animations, morph targets) is left out.
Scene loadGltf(const std::filesystem::path& path);

}  // namespace host
