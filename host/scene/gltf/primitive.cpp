#include "host/scene/gltf/primitive.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

#include "host/scene/gltf/surface_frame.h"
#include "host/scene/gltf/triangle_corners.h"

namespace host::gltf {
namespace {

// Beyond this, squared distances overflow once a node has scaled them (see kMaxTransform in nodes.cpp).
constexpr float kMaxCoordinate = 1e9f;

bool isUsable(glm::vec3 position) {
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(position[i]) <= kMaxCoordinate)) return false;  // NaN, too
  }
  return true;
}

glm::vec4 finiteOrZero(glm::vec4 value) {
  for (int i = 0; i < 4; ++i) {
    if (!std::isfinite(value[i])) return glm::vec4(0.0f);
  }
  return value;
}

}  // namespace

bool hasTriangles(const tinygltf::Primitive& primitive) {
  return triangleCount(primitive.mode, 3) > 0 && primitive.attributes.contains("POSITION");
}

struct PrimitiveReader::Attributes {
  std::optional<Accessor> normals;
  std::optional<Accessor> tangents;
  std::optional<Accessor> uvs;
};

PrimitiveReader::PrimitiveReader(Document& document, const tinygltf::Primitive& primitive, std::string name)
    : document_(document),
      primitive_(primitive),
      name_(std::move(name)),
      positions_(document, primitive.attributes.at("POSITION"), "the positions of " + name_) {
  if (positions_.components() != 3) {
    throw std::runtime_error(
        fmt::format("the positions of {} are no 3-vectors; export the file again", name_));
  }
  if (primitive.indices == -1) return;
  indices_.emplace(document, primitive.indices, "the indices of " + name_);
  if (indices_->components() != 1 || !indices_->isUnsignedInteger()) {
    throw std::runtime_error(
        fmt::format("the indices of {} are no unsigned integers; export the file again", name_));
  }
}

std::size_t PrimitiveReader::triangleCount() const {
  return gltf::triangleCount(primitive_.mode, indices_ ? indices_->count() : positions_.count());
}

Mesh PrimitiveReader::read(const Material& material, int uvSet) {
  const Attributes attributes{attribute("NORMAL", 3), attribute("TANGENT", 4),
                              attribute(fmt::format("TEXCOORD_{}", uvSet), 2)};
  Mesh mesh = readVertices(validCorners(), attributes);
  if (attributes.normals) {
    repairNormals(mesh);
  } else {
    addFlatNormals(mesh);
  }
  // glTF 2.0, section 3.7.2.1: tangents without normals are to be ignored.
  const bool hasTangents = attributes.tangents && attributes.normals;
  if (!hasTangents && material.normalTexture.texture >= 0) {
    addTangents(mesh, material.normalTexture.uvTransform);
  } else {
    repairTangents(mesh);
  }
  return mesh;
}

std::vector<std::uint32_t> PrimitiveReader::validCorners() {
  std::vector<std::uint32_t> corners =
      triangleCorners(primitive_.mode, indices_ ? &*indices_ : nullptr, positions_.count(), name_);
  std::size_t kept = 0;
  for (std::size_t first = 0; first < corners.size(); first += 3) {
    const auto triangle = corners.begin() + std::ptrdiff_t(first);
    const bool valid = std::all_of(triangle, triangle + 3, [this](std::uint32_t vertex) {
      return isUsable(glm::vec3(positions_.vector(vertex)));
    });
    if (!valid) continue;
    std::copy(triangle, triangle + 3, corners.begin() + std::ptrdiff_t(kept));
    kept += 3;
  }
  if (kept < corners.size()) {
    document_.warnings.push_back(
        fmt::format("{} triangles of {} are left out: their positions are not finite.",
                    (corners.size() - kept) / 3, name_));
    corners.resize(kept);
  }
  return corners;
}

Mesh PrimitiveReader::readVertices(const std::vector<std::uint32_t>& corners,
                                   const Attributes& attributes) const {
  // Primitives often share one big set of vertices, of which each uses a few.
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> remap(
      corners.empty() ? 0 : *std::max_element(corners.begin(), corners.end()) + 1U, kUnused);
  Mesh mesh;
  mesh.indices.reserve(corners.size());
  for (const std::uint32_t source : corners) {
    if (remap[source] == kUnused) {
      remap[source] = std::uint32_t(mesh.vertices.size());
      Vertex vertex;
      vertex.position = glm::vec3(positions_.vector(source));
      if (attributes.normals) vertex.normal = glm::vec3(finiteOrZero(attributes.normals->vector(source)));
      if (attributes.tangents) vertex.tangent = finiteOrZero(attributes.tangents->vector(source));
      if (attributes.uvs) vertex.uv = glm::vec2(finiteOrZero(attributes.uvs->vector(source)));
      mesh.vertices.push_back(vertex);
    }
    mesh.indices.push_back(remap[source]);
  }
  return mesh;
}

std::optional<Accessor> PrimitiveReader::attribute(const std::string& semantic, int components) {
  const auto found = primitive_.attributes.find(semantic);
  if (found == primitive_.attributes.end()) return std::nullopt;
  Accessor accessor(document_, found->second, fmt::format("{} of {}", semantic, name_));
  if (accessor.components() == components && accessor.count() >= positions_.count()) return accessor;
  document_.warnings.push_back(
      fmt::format("{} of {} is left out: it does not fit the positions.", semantic, name_));
  return std::nullopt;
}

}  // namespace host::gltf
