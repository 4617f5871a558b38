// Checked reading of glTF accessors. Everything is validated on construction; reading an element cannot go
// wrong.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string_view>

#include "host/scene/gltf/document.h"

namespace host::gltf {

/// The bytes of a buffer view. Throws std::runtime_error unless they lie within the view's buffer.
std::span<const std::uint8_t> bufferViewBytes(const Document& document, std::int64_t index);

class Accessor {
 public:
  /// `purpose` names the accessor in messages, such as "the positions of mesh 3". `document` must outlive
  /// this.
  Accessor(const Document& document, int index, std::string_view purpose);

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] int components() const { return components_; }
  [[nodiscard]] bool isUnsignedInteger() const;  ///< as indices must be

  /// As floating point, normalised integers mapped to 0..1 or -1..1. Components that the type lacks are zero.
  [[nodiscard]] glm::vec4 vector(std::size_t element) const;

  /// The first component of an unsigned integer accessor.
  [[nodiscard]] std::uint32_t integer(std::size_t element) const;

 private:
  /// Elements at a fixed distance in memory; no data reads as zeros.
  struct Elements {
    const std::uint8_t* data = nullptr;
    std::size_t stride = 0;
  };

  [[nodiscard]] Elements elementsOf(const Document& document, int view, std::size_t offset, std::size_t count,
                                    std::size_t elementSize) const;
  void readSparse(const Document& document, const tinygltf::Accessor& source);
  [[nodiscard]] const std::uint8_t* bytesOf(std::size_t element) const;
  [[noreturn]] void fail(std::string_view what) const;

  std::string purpose_;
  std::size_t count_ = 0;
  int components_ = 0;
  int componentType_ = 0;
  std::size_t componentSize_ = 0;
  bool normalized_ = false;
  Elements dense_;
  std::vector<std::uint32_t> sparseIndices_;  ///< increasing
  Elements sparseValues_;
};

}  // namespace host::gltf
