// Cameras that users give to a scene's file: NAME.cameras.json beside NAME.gltf or NAME.glb.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "host/scene/scene.h"

namespace host {

/// The cameras of the file beside `scene`; none where there is no such file. A list of objects:
///     [{"name": "nave", "position": [0, 1.7, 8], "target": [0, 2, 0], "vertical_fov": 60}, ...]
/// Positions are metres in the world, +Y up; the field of view, 50 where it is left out, is in degrees.
/// Clipping planes fit `bounds`, the scene's. Throws std::runtime_error with a sentence for a file that is no
/// such list.
std::optional<std::vector<Camera>> camerasBeside(const std::filesystem::path& scene, const Bounds& bounds);

}  // namespace host
