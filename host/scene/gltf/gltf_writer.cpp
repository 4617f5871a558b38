#include "host/scene/gltf/gltf_writer.h"

#include <cstring>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <tiny_gltf.h>

#include "host/image/image_file.h"

namespace host {
namespace {

std::vector<double> toDoubles(const float* values, int count) {
  return {values, values + count};
}

class GlbWriter {
 public:
  explicit GlbWriter(const Scene& scene) : scene_(scene) {
    model_.asset.version = "2.0";
    model_.asset.generator = "mres";
    model_.buffers.emplace_back();
    model_.scenes.emplace_back();
    model_.defaultScene = 0;
    for (const Material& material : scene.materials) addMaterial(material);
    for (const Mesh& mesh : scene.meshes) addMesh(mesh);
    for (const Instance& instance : scene.instances) addNode(instance.transform).mesh = instance.mesh;
  }

  void addCamera(const Camera& camera) {
    tinygltf::Camera& target = model_.cameras.emplace_back();
    target.name = camera.name;
    if (camera.orthographicHeight) {
      target.type = "orthographic";
      target.orthographic.ymag = target.orthographic.xmag = 0.5 * double(*camera.orthographicHeight);
      target.orthographic.znear = camera.nearPlane;
      target.orthographic.zfar = camera.farPlane;
    } else {
      target.type = "perspective";
      target.perspective.yfov = camera.verticalFov;
      target.perspective.znear = camera.nearPlane;
      target.perspective.zfar = camera.farPlane;  // tinygltf leaves out 0, which is how glTF says infinite
    }
    addNode(glm::inverse(viewMatrix(camera))).camera = int(model_.cameras.size()) - 1;
  }

  std::string write() {
    std::ostringstream stream;
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model_, stream, false, true))
      throw std::runtime_error("The scene can't be written as glTF.");
    return stream.str();
  }

 private:
  tinygltf::Node& addNode(const glm::mat4& transform) {
    model_.scenes[0].nodes.push_back(int(model_.nodes.size()));
    tinygltf::Node& node = model_.nodes.emplace_back();
    if (transform != glm::mat4(1.0f)) node.matrix = toDoubles(glm::value_ptr(transform), 16);
    return node;
  }

  void addMaterial(const Material& material) {
    tinygltf::Material& target = model_.materials.emplace_back();
    target.name = material.name;
    target.doubleSided = material.doubleSided;
    target.pbrMetallicRoughness.baseColorFactor = toDoubles(glm::value_ptr(material.baseColor), 4);
    target.pbrMetallicRoughness.metallicFactor = material.metallic;
    target.pbrMetallicRoughness.roughnessFactor = material.roughness;
    if (material.alphaMode == AlphaMode::blend) target.alphaMode = "BLEND";
    if (material.alphaMode != AlphaMode::mask) return;
    target.alphaMode = "MASK";
    target.alphaCutoff = material.alphaCutoff;
    if (const int texture = material.baseColorTexture.texture; texture >= 0)
      target.pbrMetallicRoughness.baseColorTexture.index = addTexture(scene_.textures[std::size_t(texture)]);
  }

  int addTexture(const Texture& texture) {
    const auto numberOf = [](Wrap wrap) {
      if (wrap == Wrap::clampToEdge) return TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
      return wrap == Wrap::repeat ? TINYGLTF_TEXTURE_WRAP_REPEAT : TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT;
    };
    tinygltf::Sampler& sampler = model_.samplers.emplace_back();
    sampler.wrapS = numberOf(texture.wrapS);
    sampler.wrapT = numberOf(texture.wrapT);
    if (texture.nearest) sampler.magFilter = TINYGLTF_TEXTURE_FILTER_NEAREST;
    const int image = imageOf(texture.image);
    tinygltf::Texture& target = model_.textures.emplace_back();
    target.sampler = int(model_.samplers.size()) - 1;
    target.source = image;
    return int(model_.textures.size()) - 1;
  }

  int imageOf(int index) {
    if (const auto known = images_.find(index); known != images_.end()) return known->second;
    const Image& image = scene_.images[std::size_t(index)];
    FloatImage pixels{image.size, 4, {}};
    for (const std::uint8_t value : image.pixels) pixels.pixels.push_back(float(value) / 255.0f);
    const std::vector<unsigned char> png = encodePng(pixels);
    tinygltf::Image& target = model_.images.emplace_back();
    target.mimeType = "image/png";
    target.bufferView = addView(png.data(), png.size(), 0);
    return images_[index] = int(model_.images.size()) - 1;
  }

  void addMesh(const Mesh& mesh) {
    const bool hasHoles =
        mesh.material >= 0 &&
        model_.materials[std::size_t(mesh.material)].pbrMetallicRoughness.baseColorTexture.index >= 0;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> uvs;
    for (const Vertex& vertex : mesh.vertices) {
      positions.push_back(vertex.position);
      normals.push_back(vertex.normal);
      if (!hasHoles) continue;
      const TextureUse& use = scene_.materials[std::size_t(mesh.material)].baseColorTexture;
      uvs.emplace_back(use.uvTransform * glm::vec3(vertex.uv, 1.0f));
    }
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = mesh.material;
    primitive.attributes["POSITION"] = addAttribute(positions, TINYGLTF_TYPE_VEC3);
    setBounds(primitive.attributes["POSITION"], positions);
    primitive.attributes["NORMAL"] = addAttribute(normals, TINYGLTF_TYPE_VEC3);
    if (hasHoles) primitive.attributes["TEXCOORD_0"] = addAttribute(uvs, TINYGLTF_TYPE_VEC2);
    primitive.indices = addAccessor(mesh.indices, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR,
                                    TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    tinygltf::Mesh& target = model_.meshes.emplace_back();
    target.name = mesh.name;
    target.primitives.push_back(primitive);
  }

  template <typename Vector>
  int addAttribute(const std::vector<Vector>& values, int type) {
    return addAccessor(values, TINYGLTF_COMPONENT_TYPE_FLOAT, type, TINYGLTF_TARGET_ARRAY_BUFFER);
  }

  template <typename T>
  int addAccessor(const std::vector<T>& values, int componentType, int type, int bufferTarget) {
    const int view = addView(values.data(), values.size() * sizeof(T), bufferTarget);
    tinygltf::Accessor& accessor = model_.accessors.emplace_back();
    accessor.bufferView = view;
    accessor.componentType = componentType;
    accessor.type = type;
    accessor.count = values.size();
    return int(model_.accessors.size()) - 1;
  }

  /// glTF demands them of positions.
  void setBounds(int accessor, const std::vector<glm::vec3>& positions) {
    Bounds bounds{glm::vec3(std::numeric_limits<float>::max()),
                  glm::vec3(std::numeric_limits<float>::lowest())};
    for (const glm::vec3& position : positions) {
      bounds.min = glm::min(bounds.min, position);
      bounds.max = glm::max(bounds.max, position);
    }
    model_.accessors[std::size_t(accessor)].minValues = toDoubles(glm::value_ptr(bounds.min), 3);
    model_.accessors[std::size_t(accessor)].maxValues = toDoubles(glm::value_ptr(bounds.max), 3);
  }

  int addView(const void* bytes, std::size_t size, int bufferTarget) {
    std::vector<unsigned char>& buffer = model_.buffers[0].data;
    constexpr std::size_t kAlignment = 4;  // of the largest component
    buffer.resize((buffer.size() + kAlignment - 1) / kAlignment * kAlignment);
    tinygltf::BufferView& view = model_.bufferViews.emplace_back();
    view.buffer = 0;
    view.byteOffset = buffer.size();
    view.byteLength = size;
    view.target = bufferTarget;
    buffer.resize(buffer.size() + size);
    if (size > 0) std::memcpy(buffer.data() + view.byteOffset, bytes, size);
    return int(model_.bufferViews.size()) - 1;
  }

  const Scene& scene_;
  tinygltf::Model model_;
  std::map<int, int> images_;  ///< the scene's index to the file's
};

}  // namespace

std::string toGlb(const Scene& scene, std::span<const int> cameras) {
  GlbWriter writer(scene);
  for (const int camera : cameras) writer.addCamera(scene.cameras.at(std::size_t(camera)));
  return writer.write();
}

}  // namespace host
