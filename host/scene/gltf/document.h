// A glTF file taken apart: its structure as tinygltf reads it, and the bytes that the structure points into.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <tiny_gltf.h>
#include <vector>

namespace host::gltf {

using Bytes = std::vector<std::uint8_t>;

/// Where the encoded bytes of an image are: in a buffer view or behind a URI.
struct ImageSource {
  std::string name;
  std::string uri;
  std::optional<std::int64_t> bufferView;
};

struct Document {
  std::filesystem::path folder;       ///< what relative URIs start from
  tinygltf::Model model;              ///< all but buffers and images, which are held below
  std::vector<Bytes> buffers;         ///< at least as long as their byteLength says
  std::vector<ImageSource> images;    ///< not decoded; most files hold some that nothing uses
  std::vector<std::string> warnings;  ///< what was left out, a sentence each
};

/// Reads .gltf or .glb (told apart by content). Throws std::runtime_error saying what is wrong and what to
/// do.
Document readDocument(const std::filesystem::path& path);

}  // namespace host::gltf
