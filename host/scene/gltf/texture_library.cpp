#include "host/scene/gltf/texture_library.h"

#include <fmt/format.h>
#include <span>
#include <stdexcept>

#include "host/scene/gltf/accessor.h"
#include "host/scene/gltf/image_decoder.h"
#include "host/scene/gltf/properties.h"
#include "host/scene/gltf/resource.h"

namespace host::gltf {
namespace {

Wrap toWrap(int gltfWrap) {
  switch (gltfWrap) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return Wrap::clampToEdge;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return Wrap::mirroredRepeat;
    default:
      return Wrap::repeat;
  }
}

/// EXT_texture_webp names its image in the extension, and a PNG or JPEG for others beside it.
int sourceImage(const tinygltf::Texture& texture) {
  const tinygltf::Value* webp = findExtension(texture.extensions, "EXT_texture_webp");
  return webp == nullptr ? texture.source : integerMember(*webp, "source", texture.source);
}

Image loadImage(const Document& document, const ImageSource& source) {
  if (source.bufferView) return decodeImage(bufferViewBytes(document, *source.bufferView));
  if (source.uri.empty()) throw std::runtime_error("it has neither data nor a URI");
  return decodeImage(readUri(source.uri, document.folder));
}

/// OpenImageIO's messages have several.
std::string firstLine(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

template <typename Convert>
int memoized(std::map<int, int>& known, int key, Convert convert) {
  if (const auto found = known.find(key); found != known.end()) return found->second;
  const int value = convert(key);
  known.emplace(key, value);
  return value;
}

}  // namespace

int TextureLibrary::use(int gltfTexture) {
  return memoized(textures_, gltfTexture, [this](int index) { return convert(index); });
}

int TextureLibrary::convert(int gltfTexture) {
  const tinygltf::Model& model = document_.model;
  if (gltfTexture < 0 || std::size_t(gltfTexture) >= model.textures.size()) {
    document_.warnings.push_back(fmt::format("Texture {} does not exist; it is left out.", gltfTexture));
    return -1;
  }
  const tinygltf::Texture& source = model.textures[std::size_t(gltfTexture)];
  Texture texture;
  texture.image = useImage(sourceImage(source));
  if (texture.image < 0) {
    document_.warnings.push_back(
        fmt::format("Texture {} is left out: it has no readable image.", gltfTexture));
    return -1;
  }
  if (source.sampler >= 0 && std::size_t(source.sampler) < model.samplers.size()) {
    const tinygltf::Sampler& sampler = model.samplers[std::size_t(source.sampler)];
    texture.wrapS = toWrap(sampler.wrapS);
    texture.wrapT = toWrap(sampler.wrapT);
    texture.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
  }
  scene_.textures.push_back(texture);
  return int(scene_.textures.size()) - 1;
}

int TextureLibrary::useImage(int gltfImage) {
  return memoized(images_, gltfImage, [this](int index) { return decode(index); });
}

int TextureLibrary::decode(int gltfImage) {
  if (gltfImage < 0 || std::size_t(gltfImage) >= document_.images.size()) {
    return -1;  // whoever wanted it warns
  }
  const ImageSource& source = document_.images[std::size_t(gltfImage)];
  try {
    Image image = loadImage(document_, source);
    image.name = source.name.empty() ? abbreviated(source.uri) : source.name;
    scene_.images.push_back(std::move(image));
    return int(scene_.images.size()) - 1;
  } catch (const std::exception& error) {
    document_.warnings.push_back(fmt::format("Image {} '{}' can't be read: {}.", gltfImage,
                                             abbreviated(source.uri), firstLine(error.what())));
    return -1;
  }
}

}  // namespace host::gltf
