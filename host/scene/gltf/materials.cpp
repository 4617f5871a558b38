#include "host/scene/gltf/materials.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "host/scene/gltf/properties.h"
#include "host/scene/gltf/texture_library.h"

namespace host::gltf {
namespace {

/// A texture of a material, wherever it was written: a field of tinygltf's or an extension's object.
struct TextureReference {
  int index = -1;
  int texCoord = 0;
  glm::mat3 uvTransform{1.0f};
};

/// KHR_texture_transform: scale, then rotation, then offset. Counter-clockwise on the screen, where v points
/// down; the extension's second example (the lower left quadrant) settles the sign.
glm::mat3 uvTransformOf(const tinygltf::Value& transform) {
  const auto pair = [&transform](const char* name, float fallback) {
    const std::vector<double> values = numbersMember(transform, name);
    return values.size() == 2 ? glm::vec2(toFloat(values[0]), toFloat(values[1])) : glm::vec2(fallback);
  };
  const glm::vec2 offset = pair("offset", 0.0f);
  const glm::vec2 scale = pair("scale", 1.0f);
  const float rotation = toFloat(numberMember(transform, "rotation", 0.0));
  const float c = std::cos(rotation);
  const float s = std::sin(rotation);
  return {glm::vec3(c, -s, 0.0f) * scale.x, glm::vec3(s, c, 0.0f) * scale.y, glm::vec3(offset, 1.0f)};
}

void applyTextureTransform(TextureReference& reference, const tinygltf::Value* transform) {
  if (transform == nullptr) return;
  reference.uvTransform = uvTransformOf(*transform);
  reference.texCoord = integerMember(*transform, "texCoord", reference.texCoord);
}

/// Of a tinygltf::TextureInfo or NormalTextureInfo.
template <typename TextureInfo>
TextureReference referenceOf(const TextureInfo& info) {
  TextureReference reference{info.index, info.texCoord};
  applyTextureTransform(reference, findExtension(info.extensions, "KHR_texture_transform"));
  return reference;
}

/// Of a textureInfo object inside of an extension.
TextureReference referenceOf(const tinygltf::Value* info) {
  TextureReference reference;
  if (info == nullptr) return reference;
  reference.index = integerMember(*info, "index", -1);
  reference.texCoord = integerMember(*info, "texCoord", 0);
  if (const tinygltf::Value* extensions = findMember(*info, "extensions")) {
    applyTextureTransform(reference, findMember(*extensions, "KHR_texture_transform"));
  }
  return reference;
}

AlphaMode toAlphaMode(const std::string& mode) {
  if (mode == "MASK") return AlphaMode::mask;
  return mode == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
}

glm::vec4 toColor(const std::vector<double>& values) {
  return glm::clamp(toVec4(values, glm::vec4(1.0f)), 0.0f, 1.0f);
}

float toUnit(double value) {
  return std::clamp(toFloat(value), 0.0f, 1.0f);
}

class MaterialConverter {
 public:
  MaterialConverter(const tinygltf::Material& source, TextureLibrary& textures,
                    std::vector<std::string>& warnings)
      : source_(source), textures_(textures), warnings_(warnings) {}

  Material convert() {
    material_.name = source_.name;
    convertBase();
    convertNormal();
    convertEmission();
    material_.alphaMode = toAlphaMode(source_.alphaMode);
    material_.alphaCutoff = std::max(toFloat(source_.alphaCutoff), 0.0f);
    material_.doubleSided = source_.doubleSided;
    if (source_.extensions.contains("KHR_materials_unlit")) makeUnlit();
    return material_;
  }

  [[nodiscard]] int uvSet() const { return uvSet_.value_or(0); }

 private:
  /// tinygltf keeps the members of pbrMetallicRoughness in `values`; without any, the older model counts.
  void convertBase() {
    const auto* specularGlossiness = findExtension(source_.extensions, "KHR_materials_pbrSpecularGlossiness");
    if (specularGlossiness != nullptr && source_.values.empty()) {
      convertSpecularGlossiness(*specularGlossiness);
    } else {
      convertMetallicRoughness(source_.pbrMetallicRoughness);
    }
  }

  void convertMetallicRoughness(const tinygltf::PbrMetallicRoughness& pbr) {
    material_.baseColor = toColor(pbr.baseColorFactor);
    material_.metallic = toUnit(pbr.metallicFactor);
    material_.roughness = toUnit(pbr.roughnessFactor);
    material_.baseColorTexture = use(referenceOf(pbr.baseColorTexture));
    material_.metallicRoughnessTexture = use(referenceOf(pbr.metallicRoughnessTexture));
    const bool lost =
        pbr.metallicRoughnessTexture.index != -1 && material_.metallicRoughnessTexture.texture < 0;
    if (lost) material_.metallic = 0.0f;
  }

  /// Diffuse is the base colour of a dielectric; coloured specular reflection is left out.
  void convertSpecularGlossiness(const tinygltf::Value& extension) {
    material_.baseColor = toColor(numbersMember(extension, "diffuseFactor"));
    material_.metallic = 0.0f;
    material_.roughness = 1.0f - toUnit(numberMember(extension, "glossinessFactor", 1.0));
    material_.baseColorTexture = use(referenceOf(findMember(extension, "diffuseTexture")));
  }

  void convertNormal() {
    material_.normalTexture = use(referenceOf(source_.normalTexture));
    material_.normalScale = toFloat(source_.normalTexture.scale);
  }

  void convertEmission() {
    const glm::vec3 factor = glm::max(toVec3(source_.emissiveFactor, glm::vec3(0.0f)), 0.0f);
    const auto* strength = findExtension(source_.extensions, "KHR_materials_emissive_strength");
    const double scale = strength == nullptr ? 1.0 : numberMember(*strength, "emissiveStrength", 1.0);
    material_.emissive = factor * std::max(toFloat(scale), 0.0f);
    if (factor == glm::vec3(0.0f)) return;  // the texture could not show
    material_.emissiveTexture = use(referenceOf(source_.emissiveTexture));
    const bool lost = source_.emissiveTexture.index != -1 && material_.emissiveTexture.texture < 0;
    if (lost) material_.emissive = glm::vec3(0.0f);
  }

  void makeUnlit() {
    material_.emissive = glm::vec3(material_.baseColor);
    material_.emissiveTexture = material_.baseColorTexture;
    material_.baseColor = glm::vec4(glm::vec3(0.0f), material_.baseColor.a);
    material_.metallic = 0.0f;
    material_.roughness = 1.0f;
    material_.metallicRoughnessTexture = {};
    material_.normalTexture = {};
  }

  TextureUse use(const TextureReference& reference) {
    if (reference.index == -1) return {};
    if (uvSet_.value_or(reference.texCoord) != reference.texCoord) {
      warnings_.push_back(
          fmt::format("Texture {} of material '{}' is left out: it reads TEXCOORD_{}, the others "
                      "TEXCOORD_{}.",
                      reference.index, source_.name, reference.texCoord, *uvSet_));
      return {};
    }
    const int texture = textures_.use(reference.index);
    if (texture < 0) return {};
    uvSet_ = reference.texCoord;
    return {texture, reference.uvTransform};
  }

  const tinygltf::Material& source_;
  TextureLibrary& textures_;
  std::vector<std::string>& warnings_;
  Material material_;
  std::optional<int> uvSet_;
};

}  // namespace

std::vector<int> convertMaterials(Document& document, Scene& scene) {
  TextureLibrary textures(document, scene);
  std::vector<int> uvSets;
  for (const tinygltf::Material& source : document.model.materials) {
    MaterialConverter converter(source, textures, document.warnings);
    scene.materials.push_back(converter.convert());
    uvSets.push_back(converter.uvSet());
  }
  return uvSets;
}

}  // namespace host::gltf
