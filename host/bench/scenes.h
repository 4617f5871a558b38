#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/bench/suite.h"

namespace host {

/// The scenes of files and of folders, of which every .gltf and .glb below counts, in the order of their
/// names. They are called as their files, with as many of the folders above as it takes to tell them apart.
/// Throws std::runtime_error with a sentence for a path that does not exist or that has no scene.
std::vector<BenchScene> findScenes(const std::vector<std::filesystem::path>& paths);

}  // namespace host
