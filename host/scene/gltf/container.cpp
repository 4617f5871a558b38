#include "host/scene/gltf/container.h"

#include <fmt/format.h>
#include <stdexcept>

namespace host::gltf {
namespace {

// glTF 2.0, section 4.4 (binary glTF layout): twelve bytes of header, then chunks of length, type, payload,
// all little-endian.
constexpr std::uint32_t kMagic = 0x46546C67;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::size_t kHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;

std::uint32_t readUint32(std::span<const std::uint8_t> bytes, std::size_t offset) {
  return std::uint32_t(bytes[offset]) | std::uint32_t(bytes[offset + 1]) << 8U |
         std::uint32_t(bytes[offset + 2]) << 16U | std::uint32_t(bytes[offset + 3]) << 24U;
}

bool isGlb(std::span<const std::uint8_t> file) {
  return file.size() >= 4 && readUint32(file, 0) == kMagic;
}

/// The file from the first chunk to the length that the header gives.
std::span<const std::uint8_t> chunksOf(std::span<const std::uint8_t> file) {
  if (file.size() < kHeaderSize) throw std::runtime_error("the GLB header is cut short; get a complete copy");
  if (const auto version = readUint32(file, 4); version != 2) {
    throw std::runtime_error(
        fmt::format("it is GLB version {}, but only 2 is known; export as glTF 2.0", version));
  }
  const std::size_t length = readUint32(file, 8);
  if (length < kHeaderSize || length > file.size()) {
    throw std::runtime_error(fmt::format(
        "the GLB header promises {} bytes, but the file has {}; get a complete copy", length, file.size()));
  }
  return file.subspan(kHeaderSize, length - kHeaderSize);
}

struct Chunk {
  std::uint32_t type;
  std::span<const std::uint8_t> payload;
};

/// Takes the first chunk off `rest`.
Chunk takeChunk(std::span<const std::uint8_t>& rest) {
  if (rest.size() < kChunkHeaderSize) {
    throw std::runtime_error("a GLB chunk's header is cut short; get a complete copy");
  }
  const std::size_t length = readUint32(rest, 0);
  const std::uint32_t type = readUint32(rest, 4);
  rest = rest.subspan(kChunkHeaderSize);
  if (length > rest.size()) {
    throw std::runtime_error(fmt::format(
        "a GLB chunk promises {} bytes, but only {} follow; get a complete copy", length, rest.size()));
  }
  const Chunk chunk{type, rest.first(length)};
  rest = rest.subspan(length);
  return chunk;
}

}  // namespace

Container openContainer(std::span<const std::uint8_t> file) {
  const auto asText = [](std::span<const std::uint8_t> bytes) {
    return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  if (!isGlb(file)) return {asText(file), std::nullopt};

  auto rest = chunksOf(file);
  const Chunk json = takeChunk(rest);
  if (json.type != kJsonChunk)
    throw std::runtime_error("the first GLB chunk is not JSON; export the file again");
  Container container{asText(json.payload), std::nullopt};
  if (rest.empty()) return container;
  // Only the chunk right after the JSON can be the binary one; chunks of other types are for extensions.
  if (const Chunk second = takeChunk(rest); second.type == kBinaryChunk) container.binary = second.payload;
  return container;
}

}  // namespace host::gltf
