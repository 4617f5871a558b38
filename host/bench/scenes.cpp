#include "host/bench/scenes.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <iterator>
#include <set>
#include <stdexcept>
#include <system_error>

namespace host {
namespace fs = std::filesystem;
namespace {

bool isScene(const fs::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension == ".gltf" || extension == ".glb";
}

/// Folders that may not be read are passed over, and links to folders are not followed: they may be circles.
std::set<fs::path> scenesBelow(const fs::path& folder) {
  std::set<fs::path> scenes;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
    if (isScene(entry->path()) && entry->is_regular_file(error)) scenes.insert(entry->path());
  return scenes;
}

std::set<fs::path> scenesOf(const fs::path& path) {
  std::error_code ignored;  // what cannot be looked at is taken for missing
  if (!fs::exists(path, ignored))
    throw std::runtime_error(
        fmt::format("There is no '{}'; give .gltf or .glb files or a folder of them.", path.string()));
  if (!fs::is_directory(path, ignored)) return {path};
  std::set<fs::path> scenes = scenesBelow(path);
  if (scenes.empty())
    throw std::runtime_error(fmt::format("There is no .gltf or .glb file below '{}'.", path.string()));
  return scenes;
}

/// The file's name without extension, and `folders` of the folders above.
std::string nameOf(const fs::path& file, int folders) {
  std::string name = file.stem().string();
  fs::path above = file.parent_path();
  for (; folders > 0 && above.has_filename(); --folders, above = above.parent_path())
    name.insert(0, above.filename().string() + "-");
  return name;
}

/// Nothing names two files of the same folder that differ in their extensions alone: those have it.
std::string uniqueName(const fs::path& file, const std::set<fs::path>& all) {
  const auto count = [&](const std::string& name, int folders) {
    return std::ranges::count_if(all, [&](const fs::path& other) { return nameOf(other, folders) == name; });
  };
  const auto depth = static_cast<int>(std::distance(file.begin(), file.end()));
  for (int folders = 0; folders < depth; ++folders)
    if (std::string name = nameOf(file, folders); count(name, folders) == 1) return name;
  return nameOf(file, depth) + file.extension().string();
}

}  // namespace

std::vector<BenchScene> findScenes(const std::vector<fs::path>& paths) {
  std::set<fs::path> files;
  for (const fs::path& path : paths)
    for (const fs::path& file : scenesOf(path)) files.insert(fs::absolute(file).lexically_normal());
  std::vector<BenchScene> scenes;
  scenes.reserve(files.size());
  for (const fs::path& file : files) scenes.push_back({file.string(), uniqueName(file, files)});
  return scenes;
}

}  // namespace host
