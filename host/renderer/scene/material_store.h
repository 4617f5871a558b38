#pragma once

#include <array>
#include <vector>

#include "host/renderer/scene/texture_store.h"
#include "host/scene/scene.h"
#include "mres/gl/program.h"

namespace host {

/// All materials' uniform blocks in one buffer, and the textures that each binds.
class MaterialStore {
 public:
  explicit MaterialStore(const Scene& scene);

  /// Index of the material that meshes without one have.
  [[nodiscard]] int defaultMaterial() const { return static_cast<int>(materials_.size()) - 1; }
  [[nodiscard]] bool isBlended(int material) const { return at(material).blended; }
  [[nodiscard]] bool isDoubleSided(int material) const { return at(material).doubleSided; }

  /// Points the samplers and the block of host/material.glsl at their units; needs the program in use.
  static void connect(const mres::gl::Program& program);
  /// Binds a material's block and textures for programs that were connected.
  void bind(int material) const;

  /// One white texel.
  [[nodiscard]] GLuint white() const { return textures_.white(); }
  [[nodiscard]] std::size_t bytes() const { return textures_.bytes(); }

 private:
  struct Entry {
    std::array<TextureStore::Binding, 4> textures;
    bool blended = false;
    bool doubleSided = false;
  };
  [[nodiscard]] const Entry& at(int material) const { return materials_[static_cast<std::size_t>(material)]; }
  void add(const Scene& scene, const Material& material);
  void uploadBlocks(const Scene& scene, const Material& fallback);

  TextureStore textures_;
  std::vector<Entry> materials_;  // the scene's, then the default one
  mres::gl::BufferName blocks_;
  std::size_t blockStride_ = 0;
};

}  // namespace host
