#include "host/scene/gltf/resource.h"

#include <charconv>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>

namespace host::gltf {
namespace {

/// RFC 3986, section 2.1. A '%' that no two hexadecimal digits follow stands for itself.
std::string percentDecoded(const std::string& text) {
  std::string decoded;
  decoded.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size()) {
      unsigned value = 0;
      const char* digits = text.data() + i + 1;
      if (std::from_chars(digits, digits + 2, value, 16).ptr == digits + 2) {
        decoded += char(value);
        i += 2;
        continue;
      }
    }
    decoded += text[i];
  }
  return decoded;
}

/// RFC 2397.
Bytes decodeDataUri(const std::string& uri) {
  constexpr std::string_view kBase64 = ";base64";
  const auto comma = uri.find(',');
  if (comma == std::string::npos) {
    throw std::runtime_error(fmt::format("'{}' is no data URI; export the file again", abbreviated(uri)));
  }
  const std::string data = uri.substr(comma + 1);
  if (!std::string_view(uri).substr(0, comma).ends_with(kBase64)) {
    const std::string decoded = percentDecoded(data);
    return {decoded.begin(), decoded.end()};
  }
  // tinygltf knows a short list of media types; what the bytes are is seen from the bytes, so any will do.
  Bytes bytes;
  std::string mediaType;
  if (!tinygltf::DecodeDataURI(&bytes, mediaType, "data:application/octet-stream;base64," + data, 0, false)) {
    throw std::runtime_error(fmt::format("'{}' can't be decoded; export the file again", abbreviated(uri)));
  }
  return bytes;
}

}  // namespace

std::string abbreviated(const std::string& uri) {
  constexpr std::size_t kShown = 60;
  return uri.size() <= kShown ? uri : uri.substr(0, kShown) + "...";
}

Bytes readFile(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    throw std::runtime_error(fmt::format("'{}' does not exist; check the path", path.string()));
  }
  // Devices and pipes may never end.
  if (!std::filesystem::is_regular_file(status)) {
    throw std::runtime_error(fmt::format("'{}' is not a file; name a file", path.string()));
  }
  const auto size = std::filesystem::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  if (error || !stream) {
    throw std::runtime_error(fmt::format("'{}' can't be read; check its permissions", path.string()));
  }
  Bytes bytes(size);
  stream.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size));
  bytes.resize(std::size_t(stream.gcount()));
  return bytes;
}

Bytes readUri(const std::string& uri, const std::filesystem::path& folder) {
  if (uri.starts_with("data:")) return decodeDataUri(uri);
  if (uri.find("://") != std::string::npos) {
    throw std::runtime_error(
        fmt::format("'{}' is not a local file; download it and refer to the copy", abbreviated(uri)));
  }
  const std::string decoded = percentDecoded(uri);
  if (decoded.find('\0') != std::string::npos) {
    throw std::runtime_error(fmt::format("'{}' is no file name; export the file again", abbreviated(uri)));
  }
  return readFile(folder / decoded);
}

}  // namespace host::gltf
