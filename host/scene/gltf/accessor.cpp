#include "host/scene/gltf/accessor.h"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <span>
#include <stdexcept>

namespace host::gltf {
namespace {

// An accessor without a buffer view is all zeros and costs the file nothing, so its count means nothing
// either.
constexpr std::size_t kMaxCountWithoutData = std::size_t(1) << 24U;

template <typename T>
T load(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));  // accessors of broken files may be unaligned
  return value;
}

/// glTF 2.0, section 3.11 (normalised integers): the most negative value maps to -1, too.
template <typename T>
float loadNumber(const std::uint8_t* bytes, bool normalized) {
  const auto value = float(load<T>(bytes));
  return normalized ? std::max(value / float(std::numeric_limits<T>::max()), -1.0f) : value;
}

float loadComponent(const std::uint8_t* bytes, int componentType, bool normalized) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return loadNumber<std::int8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return loadNumber<std::uint8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return loadNumber<std::int16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return loadNumber<std::uint16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return loadNumber<std::uint32_t>(bytes, normalized);
    default:
      return load<float>(bytes);
  }
}

std::uint32_t loadUnsigned(const std::uint8_t* bytes, int componentType) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return *bytes;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<std::uint16_t>(bytes);
    default:
      return load<std::uint32_t>(bytes);
  }
}

/// Zero for what glTF does not know, such as double.
std::size_t sizeOfComponent(int componentType) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

bool isUnsignedType(int componentType) {
  return componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
         componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

}  // namespace

std::span<const std::uint8_t> bufferViewBytes(const Document& document, std::int64_t index) {
  const auto& views = document.model.bufferViews;
  if (index < 0 || std::uint64_t(index) >= views.size()) {
    throw std::runtime_error(fmt::format("buffer view {} does not exist", index));
  }
  const tinygltf::BufferView& view = views[std::size_t(index)];
  if (view.buffer < 0 || std::size_t(view.buffer) >= document.buffers.size()) {
    throw std::runtime_error(
        fmt::format("buffer view {} is in buffer {}, which does not exist", index, view.buffer));
  }
  const Bytes& buffer = document.buffers[std::size_t(view.buffer)];
  if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset) {
    throw std::runtime_error(
        fmt::format("buffer view {} reaches past the end of buffer {}", index, view.buffer));
  }
  return std::span(buffer).subspan(view.byteOffset, view.byteLength);
}

Accessor::Accessor(const Document& document, int index, std::string_view purpose) : purpose_(purpose) {
  const auto& accessors = document.model.accessors;
  if (index < 0 || std::size_t(index) >= accessors.size()) {
    fail(fmt::format("accessor {} does not exist", index));
  }
  const tinygltf::Accessor& source = accessors[std::size_t(index)];
  purpose_ += fmt::format(" (accessor {})", index);
  count_ = source.count;
  components_ = source.type == TINYGLTF_TYPE_SCALAR ? 1 : source.type;
  componentType_ = source.componentType;
  componentSize_ = sizeOfComponent(componentType_);
  normalized_ = source.normalized;
  if (components_ < 1 || components_ > 4) fail("it has matrices where vectors belong");
  if (componentSize_ == 0) fail(fmt::format("its component type {} is unknown", componentType_));
  if (source.bufferView >= 0) {
    dense_ = elementsOf(document, source.bufferView, source.byteOffset, count_, components_ * componentSize_);
  } else if (count_ > kMaxCountWithoutData) {
    fail(fmt::format("its {} elements have no data", count_));
  }
  if (source.sparse.isSparse) readSparse(document, source);
}

Accessor::Elements Accessor::elementsOf(const Document& document, int view, std::size_t offset,
                                        std::size_t count, std::size_t elementSize) const {
  std::span<const std::uint8_t> bytes;
  try {
    bytes = bufferViewBytes(document, view);
  } catch (const std::exception& error) {
    fail(error.what());
  }
  const std::size_t declaredStride = document.model.bufferViews[std::size_t(view)].byteStride;
  const std::size_t stride = declaredStride == 0 ? elementSize : declaredStride;
  if (stride < elementSize) fail("its byteStride is smaller than its elements");
  if (count == 0) return {bytes.data(), stride};
  // Without overflow: does the last element end within the view?
  if (offset > bytes.size() || bytes.size() - offset < elementSize ||
      (bytes.size() - offset - elementSize) / stride < count - 1) {
    fail(fmt::format("buffer view {} is too short for its {} elements", view, count));
  }
  return {bytes.data() + offset, stride};
}

void Accessor::readSparse(const Document& document, const tinygltf::Accessor& source) {
  const auto& sparse = source.sparse;
  if (sparse.count < 0 || std::size_t(sparse.count) > count_ || sparse.indices.byteOffset < 0 ||
      sparse.values.byteOffset < 0 || !isUnsignedType(sparse.indices.componentType)) {
    fail("its sparse data are invalid");
  }
  const auto count = std::size_t(sparse.count);
  const Elements indices =
      elementsOf(document, sparse.indices.bufferView, std::size_t(sparse.indices.byteOffset), count,
                 sizeOfComponent(sparse.indices.componentType));
  sparseValues_ = elementsOf(document, sparse.values.bufferView, std::size_t(sparse.values.byteOffset), count,
                             components_ * componentSize_);
  sparseIndices_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t index = loadUnsigned(indices.data + i * indices.stride, sparse.indices.componentType);
    if (index >= count_ || (i > 0 && index <= sparseIndices_.back())) {
      fail("its sparse indices are out of range or do not increase");
    }
    sparseIndices_.push_back(index);
  }
}

const std::uint8_t* Accessor::bytesOf(std::size_t element) const {
  const auto found = std::lower_bound(sparseIndices_.begin(), sparseIndices_.end(), element);
  if (found != sparseIndices_.end() && *found == element) {
    return sparseValues_.data + std::size_t(found - sparseIndices_.begin()) * sparseValues_.stride;
  }
  return dense_.data == nullptr ? nullptr : dense_.data + element * dense_.stride;
}

bool Accessor::isUnsignedInteger() const {
  return isUnsignedType(componentType_);
}

glm::vec4 Accessor::vector(std::size_t element) const {
  glm::vec4 result(0.0f);
  const std::uint8_t* bytes = bytesOf(element);
  if (bytes == nullptr) return result;
  for (int i = 0; i < components_; ++i) {
    result[i] = loadComponent(bytes + std::size_t(i) * componentSize_, componentType_, normalized_);
  }
  return result;
}

std::uint32_t Accessor::integer(std::size_t element) const {
  const std::uint8_t* bytes = bytesOf(element);
  return bytes == nullptr ? 0 : loadUnsigned(bytes, componentType_);
}

void Accessor::fail(std::string_view what) const {
  throw std::runtime_error(fmt::format("can't read {}: {}; export the file again", purpose_, what));
}

}  // namespace host::gltf
