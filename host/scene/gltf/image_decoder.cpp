#include "host/scene/gltf/image_decoder.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "host/files/silenced_stderr.h"

namespace host::gltf {
namespace {

// 8192 x 8192 is 256 MiB decoded. A small file can claim any size, so there must be a limit.
constexpr std::int64_t kMaxPixels = std::int64_t(8192) * 8192;

struct Signature {
  std::string_view bytes;
  const char* format;  ///< OpenImageIO's name
};

/// Media types and file names are often wrong, first bytes are not.
const char* recogniseFormat(std::span<const std::uint8_t> encoded) {
  using namespace std::string_view_literals;
  constexpr std::array kSignatures = {Signature{"\x89PNG"sv, "png"}, Signature{"\xff\xd8\xff"sv, "jpeg"},
                                      Signature{"RIFF"sv, "webp"},   Signature{"DDS "sv, "dds"},
                                      Signature{"BM"sv, "bmp"},      Signature{"GIF8"sv, "gif"}};
  const std::string_view start(reinterpret_cast<const char*>(encoded.data()),
                               std::min<std::size_t>(encoded.size(), 4));
  const auto* found =
      std::find_if(kSignatures.begin(), kSignatures.end(),
                   [start](const Signature& signature) { return start.starts_with(signature.bytes); });
  if (found == kSignatures.end()) throw std::runtime_error("it is no PNG, JPEG or WebP image");
  return found->format;
}

std::unique_ptr<OIIO::ImageInput> openImage(OIIO::Filesystem::IOMemReader& reader, const char* format) {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);  // glTF's colours are not premultiplied
  // OpenImageIO 2.4 ignores open()'s own proxy argument when it is given a configuration, too.
  OIIO::Filesystem::IOProxy* proxy = &reader;
  config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  auto input = OIIO::ImageInput::open(fmt::format("embedded.{}", format), &config);
  if (!input) throw std::runtime_error(OIIO::geterror());
  return input;
}

/// Spreads pixels of `channels` channels to RGBA.
std::vector<std::uint8_t> toRgba(const std::vector<std::uint8_t>& pixels, int channels) {
  if (channels == 4) return pixels;
  const auto stride = std::size_t(channels);
  const bool isGrey = channels <= 2;
  std::vector<std::uint8_t> rgba;
  rgba.reserve(pixels.size() / stride * 4);
  for (std::size_t i = 0; i + stride <= pixels.size(); i += stride) {
    const std::uint8_t alpha = channels == 2 ? pixels[i + 1] : 255;
    rgba.insert(rgba.end(), {pixels[i], pixels[isGrey ? i : i + 1], pixels[isGrey ? i : i + 2], alpha});
  }
  return rgba;
}

}  // namespace

Image decodeImage(std::span<const std::uint8_t> encoded) {
  const char* format = recogniseFormat(encoded);
  const SilencedStderr silence;  // what is wrong is thrown
  OIIO::Filesystem::IOMemReader reader(encoded.data(), encoded.size());
  const auto input = openImage(reader, format);
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 ||
      std::int64_t(spec.width) * spec.height > kMaxPixels) {
    throw std::runtime_error(fmt::format("its size {} x {} is out of range", spec.width, spec.height));
  }
  const int channels = std::min(spec.nchannels, 4);
  std::vector<std::uint8_t> pixels(std::size_t(spec.width) * std::size_t(spec.height) *
                                   std::size_t(channels));
  if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, pixels.data())) {
    throw std::runtime_error(input->geterror());
  }
  Image image;
  image.size = {spec.width, spec.height};
  image.pixels = toRgba(pixels, channels);
  return image;
}

}  // namespace host::gltf
