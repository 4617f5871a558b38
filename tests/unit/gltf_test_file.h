// What the glTF tests share: a builder of small files.
#pragma once

#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "host/scene/scene.h"
#include "tests/support/temporary_folder.h"

namespace gltf_test {

using Json = nlohmann::json;

using host::test::TemporaryFolder;

// glTF's numbers for component types.
inline constexpr int kByte = 5120;
inline constexpr int kUnsignedByte = 5121;
inline constexpr int kShort = 5122;
inline constexpr int kUnsignedShort = 5123;
inline constexpr int kUnsignedInt = 5125;
inline constexpr int kFloat = 5126;

/// A file in the making: its JSON, free to be changed by the test, and its one buffer.
class GltfFile {
 public:
  GltfFile();

  Json json;

  /// Adds the values as a buffer view and returns its index.
  template <typename T>
  int addView(const std::vector<T>& values, int byteStride = 0) {
    return addBytes(std::as_bytes(std::span(values)), byteStride);
  }

  /// Adds the values as an accessor with a view of its own and returns its index.
  template <typename T>
  int addAccessor(const std::vector<T>& values, int componentType, const std::string& type, int components) {
    const int view = addView(values);
    return addAccessor({{"bufferView", view},
                        {"componentType", componentType},
                        {"count", values.size() / std::size_t(components)},
                        {"type", type}});
  }
  int addAccessor(Json accessor);
  int addPositions(const std::vector<float>& values) { return addAccessor(values, kFloat, "VEC3", 3); }

  /// The primitive as the only one of a new mesh, with a root node; returns the primitive for changes.
  Json& addPrimitive(Json primitive);

  /// A unit square in the xy plane of two triangles, with texture coordinates, in a root node.
  Json& addSquare();

  /// Writes scene.gltf and scene.bin and loads them.
  [[nodiscard]] host::Scene load(const TemporaryFolder& folder) const;

  /// The message with which loading fails; empty where it does not.
  [[nodiscard]] std::string loadError(const TemporaryFolder& folder) const;

  /// As one GLB file.
  [[nodiscard]] std::string glb() const;

 private:
  int addBytes(std::span<const std::byte> bytes, int byteStride);

  std::string buffer_;
};

/// shared/scenes: MRES_SCENES, or next to the project; may not exist.
std::filesystem::path scenesFolder();

/// The lines of a tab-separated file below scenesFolder(), without its heading; empty where it is not there.
std::vector<std::vector<std::string>> readTable(const std::string& file);

}  // namespace gltf_test
