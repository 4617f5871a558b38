// Textures and images, converted and decoded when a material first uses them.
#pragma once

#include <map>

#include "host/scene/gltf/document.h"
#include "host/scene/scene.h"

namespace host::gltf {

class TextureLibrary {
 public:
  /// Adds to `scene`; both must outlive this.
  TextureLibrary(Document& document, Scene& scene) : document_(document), scene_(scene) {}

  /// The scene's texture for a glTF texture; -1, with a warning, where it or its image is missing or broken.
  int use(int gltfTexture);

 private:
  int convert(int gltfTexture);
  int useImage(int gltfImage);
  int decode(int gltfImage);

  Document& document_;
  Scene& scene_;
  std::map<int, int> textures_;  ///< glTF index to scene index
  std::map<int, int> images_;
};

}  // namespace host::gltf
