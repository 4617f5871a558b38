#include "host/renderer/scene/material_store.h"

#include "host/renderer/bindings.h"
#include "shaders/host/material_params.h"

namespace host {
namespace {

using mres::params::MaterialParams;

void setUvRows(glm::vec4 (&rows)[UV_ROWS], const glm::mat3& transform) {
  const glm::mat3 transposed = glm::transpose(transform);
  rows[0] = glm::vec4(transposed[0], 0.0f);
  rows[1] = glm::vec4(transposed[1], 0.0f);
}

MaterialParams paramsOf(const Material& material) {
  MaterialParams params{};
  params.baseColorFactor = material.baseColor;
  params.emissiveFactor = glm::vec4(material.emissive, 0.0f);
  setUvRows(params.baseColorUv, material.baseColorTexture.uvTransform);
  setUvRows(params.metallicRoughnessUv, material.metallicRoughnessTexture.uvTransform);
  setUvRows(params.normalUv, material.normalTexture.uvTransform);
  setUvRows(params.emissiveUv, material.emissiveTexture.uvTransform);
  params.metallicFactor = material.metallic;
  params.roughnessFactor = material.roughness;
  params.normalScale = material.normalTexture.texture < 0 ? 0.0f : material.normalScale;
  params.alphaCutoff = material.alphaMode == AlphaMode::mask ? material.alphaCutoff : 0.0f;
  return params;
}

std::size_t alignedBlockSize() {
  GLint alignment = 1;
  glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
  const auto step = static_cast<std::size_t>(alignment);
  return (sizeof(MaterialParams) + step - 1) / step * step;
}

}  // namespace

MaterialStore::MaterialStore(const Scene& scene)
    : blocks_(mres::gl::BufferName::create()), blockStride_(alignedBlockSize()) {
  const Material fallback;
  for (const Material& material : scene.materials) add(scene, material);
  add(scene, fallback);
  uploadBlocks(scene, fallback);
}

void MaterialStore::add(const Scene& scene, const Material& material) {
  using enum TextureStore::Content;
  materials_.push_back({{textures_.binding(scene, material.baseColorTexture, color),
                         textures_.binding(scene, material.metallicRoughnessTexture, data),
                         textures_.binding(scene, material.normalTexture, data),
                         textures_.binding(scene, material.emissiveTexture, color)},
                        material.alphaMode == AlphaMode::blend,
                        material.doubleSided});
}

void MaterialStore::uploadBlocks(const Scene& scene, const Material& fallback) {
  glBindBuffer(GL_UNIFORM_BUFFER, blocks_.id());
  glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(blockStride_ * materials_.size()), nullptr,
               GL_STATIC_DRAW);
  for (std::size_t i = 0; i < materials_.size(); ++i) {
    const MaterialParams params = paramsOf(i < scene.materials.size() ? scene.materials[i] : fallback);
    glBufferSubData(GL_UNIFORM_BUFFER, static_cast<GLintptr>(i * blockStride_), sizeof(params), &params);
  }
}

void MaterialStore::connect(const mres::gl::Program& program) {
  program.setBlockBinding("MaterialParams", bindings::kMaterial);
  program.setTextureUnit("baseColorTexture", bindings::kBaseColor);
  program.setTextureUnit("metallicRoughnessTexture", bindings::kMetallicRoughness);
  program.setTextureUnit("normalTexture", bindings::kNormal);
  program.setTextureUnit("emissiveTexture", bindings::kEmissive);
}

void MaterialStore::bind(int material) const {
  glBindBufferRange(GL_UNIFORM_BUFFER, bindings::kMaterial, blocks_.id(),
                    static_cast<GLintptr>(static_cast<std::size_t>(material) * blockStride_),
                    sizeof(MaterialParams));
  const Entry& entry = at(material);
  for (GLuint unit = 0; unit < entry.textures.size(); ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, entry.textures[unit].texture);
    glBindSampler(unit, entry.textures[unit].sampler);
  }
}

}  // namespace host
