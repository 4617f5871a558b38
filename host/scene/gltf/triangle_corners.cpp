#include "host/scene/gltf/triangle_corners.h"

#include <array>
#include <fmt/format.h>
#include <stdexcept>

namespace host::gltf {
namespace {

/// glTF 2.0, section 3.7.2.1: the elements of triangle i, ordered so that all triangles wind alike.
std::array<std::size_t, 3> elementsOfTriangle(int mode, std::size_t i) {
  switch (mode) {
    case TINYGLTF_MODE_TRIANGLE_STRIP:
      return {i, i + 1 + i % 2, i + 2 - i % 2};
    case TINYGLTF_MODE_TRIANGLE_FAN:
      return {i + 1, i + 2, 0};
    default:
      return {3 * i, 3 * i + 1, 3 * i + 2};
  }
}

}  // namespace

std::size_t triangleCount(int mode, std::size_t elements) {
  switch (mode) {
    case TINYGLTF_MODE_TRIANGLES:
      return elements / 3;
    case TINYGLTF_MODE_TRIANGLE_STRIP:
    case TINYGLTF_MODE_TRIANGLE_FAN:
      return elements < 3 ? 0 : elements - 2;
    default:
      return 0;
  }
}

std::vector<std::uint32_t> triangleCorners(int mode, const Accessor* indices, std::size_t vertexCount,
                                           std::string_view purpose) {
  const std::size_t triangles = triangleCount(mode, indices == nullptr ? vertexCount : indices->count());
  std::vector<std::uint32_t> corners;
  corners.reserve(triangles * 3);
  for (std::size_t i = 0; i < triangles; ++i) {
    for (const std::size_t element : elementsOfTriangle(mode, i)) {
      const std::uint32_t vertex = indices == nullptr ? std::uint32_t(element) : indices->integer(element);
      if (vertex >= vertexCount) {
        throw std::runtime_error(
            fmt::format("index {} of {} is {}, but there are {} vertices; export the file again", element,
                        purpose, vertex, vertexCount));
      }
      corners.push_back(vertex);
    }
  }
  return corners;
}

}  // namespace host::gltf
