#include "host/scene/gltf/mesh_library.h"

#include <fmt/format.h>
#include <stdexcept>

#include "host/scene/gltf/primitive.h"
#include "host/scene/gltf/triangle_corners.h"

namespace host::gltf {
namespace {

// A small file can name the same data any number of times, so what a file may grow to depends on its size: 64
// triangles a byte lets whole meshes be reused, and the fixed part is generous for tiny files. The upper
// limit is what fits in a few GiB.
constexpr std::size_t kMaxTriangles = 20'000'000;
constexpr std::size_t kTrianglesForFree = 100'000;
constexpr std::size_t kTrianglesPerByte = 64;

std::size_t triangleBudget(const std::vector<Bytes>& buffers) {
  std::size_t bytes = 0;
  for (const Bytes& buffer : buffers) bytes += buffer.size();
  return std::min(kMaxTriangles, kTrianglesForFree + kTrianglesPerByte * bytes);
}

}  // namespace

MeshLibrary::MeshLibrary(Document& document, Scene& scene, std::vector<int> uvSets)
    : document_(document),
      scene_(scene),
      uvSets_(std::move(uvSets)),
      triangleBudget_(triangleBudget(document.buffers)) {}

std::span<const int> MeshLibrary::use(int gltfMesh) {
  auto found = meshes_.find(gltfMesh);
  if (found == meshes_.end()) found = meshes_.emplace(gltfMesh, convert(gltfMesh)).first;
  return found->second;
}

std::vector<int> MeshLibrary::convert(int gltfMesh) {
  if (gltfMesh < 0 || std::size_t(gltfMesh) >= document_.model.meshes.size()) {
    throw std::runtime_error(
        fmt::format("a node uses mesh {}, which does not exist; export the file again", gltfMesh));
  }
  const tinygltf::Mesh& source = document_.model.meshes[std::size_t(gltfMesh)];
  std::vector<int> converted;
  for (std::size_t i = 0; i < source.primitives.size(); ++i) {
    const std::string name = fmt::format("primitive {} of mesh {} '{}'", i, gltfMesh, source.name);
    Mesh mesh = convertPrimitive(source.primitives[i], name);
    if (mesh.indices.empty()) continue;
    mesh.name = source.name;
    converted.push_back(int(scene_.meshes.size()));
    scene_.meshes.push_back(std::move(mesh));
  }
  return converted;
}

Mesh MeshLibrary::convertPrimitive(const tinygltf::Primitive& primitive, const std::string& name) {
  if (!hasTriangles(primitive)) {
    document_.warnings.push_back(fmt::format("No triangles in {}; it is left out.", name));
    return {};
  }
  const int material = materialOf(primitive, name);
  PrimitiveReader reader(document_, primitive, name);
  charge(reader.triangleCount());
  Mesh mesh = material < 0
                  ? reader.read(Material{}, 0)
                  : reader.read(scene_.materials[std::size_t(material)], uvSets_[std::size_t(material)]);
  mesh.material = material;
  return mesh;
}

int MeshLibrary::materialOf(const tinygltf::Primitive& primitive, const std::string& name) {
  if (primitive.material == -1) return -1;
  if (primitive.material < -1 || std::size_t(primitive.material) >= scene_.materials.size()) {
    document_.warnings.push_back(
        fmt::format("Material {} does not exist; {} gets the default one.", primitive.material, name));
    return -1;
  }
  return primitive.material;
}

void MeshLibrary::charge(std::size_t triangles) {
  if (triangles > triangleBudget_) {
    throw std::runtime_error(
        "it has more triangles than are supported or than its size can justify; split or simplify it");
  }
  triangleBudget_ -= triangles;
}

}  // namespace host::gltf
