#include "host/image/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

#include "host/files/silenced_stderr.h"
#include "host/files/temporary_file.h"

namespace host {
namespace {

struct Writer {
  const char* name;  ///< OpenImageIO's
  OIIO::TypeDesc pixelType;
  const char* colorSpace;
};

Writer writerOf(ImageFormat format) {
  return format == ImageFormat::png ? Writer{"png", OIIO::TypeDesc::UINT8, "sRGB"}
                                    : Writer{"openexr", OIIO::TypeDesc::HALF, "Linear"};
}

OIIO::ImageSpec specFor(const FloatImage& image, const Writer& writer) {
  OIIO::ImageSpec spec(image.size.x, image.size.y, image.channels, writer.pixelType);
  spec.attribute("oiio:ColorSpace", writer.colorSpace);
  spec.attribute("oiio:UnassociatedAlpha", 1);  // the values are stored as they are
  spec.attribute("Compression", "jpeg:95");     // of JPEG; others take no notice
  spec.attribute("jpeg:subsampling", "4:4:4");
  return spec;
}

/// OpenImageIO clamps to the range of integers and rounds; what it makes of NaN is not defined.
std::vector<float> withoutNan(std::vector<float> pixels) {
  std::replace_if(
      pixels.begin(), pixels.end(), [](float value) { return std::isnan(value); }, 0.0f);
  return pixels;
}

/// In memory: OpenImageIO's PNG writer does not notice a full disk.
std::vector<unsigned char> encode(const FloatImage& image, const Writer& writer) {
  const SilencedStderr silence;  // what is wrong is thrown
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput proxy(bytes);  // outlives the output, which may still write when it is closed
  const auto output = OIIO::ImageOutput::create(writer.name);
  if (!output) throw std::runtime_error(OIIO::geterror());
  const bool isInteger = writer.pixelType == OIIO::TypeDesc::UINT8;
  const std::vector<float> sanitized = isInteger ? withoutNan(image.pixels) : std::vector<float>();
  const std::vector<float>& pixels = isInteger ? sanitized : image.pixels;
  const bool encoded = output->set_ioproxy(&proxy) && output->open(writer.name, specFor(image, writer)) &&
                       output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && output->close();
  if (!encoded) throw std::runtime_error(output->geterror());
  return bytes;
}

void writeBytes(const std::filesystem::path& path, const std::vector<unsigned char>& bytes) {
  std::ofstream stream(path, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  stream.close();
  if (!stream)
    throw std::runtime_error("the disk is full or not writable; make room or choose another folder");
}

void checkFolder(const std::filesystem::path& path) {
  const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored)) {
    throw std::runtime_error(fmt::format("the folder '{}' does not exist; create it", folder.string()));
  }
  if (::access(folder.c_str(), W_OK) != 0) {
    throw std::runtime_error(fmt::format("the folder '{}' is not writable; choose another", folder.string()));
  }
  if (std::filesystem::is_directory(path, ignored))
    throw std::runtime_error("it is a folder; add a file name");
}

void checkImage(const FloatImage& image) {
  const bool hasShape = image.size.x > 0 && image.size.y > 0 &&
                        (image.channels == 1 || image.channels == 3 || image.channels == 4);
  const std::size_t expected =
      hasShape ? std::size_t(image.size.x) * std::size_t(image.size.y) * std::size_t(image.channels) : 0;
  if (expected == 0 || image.pixels.size() != expected) {
    throw std::runtime_error(fmt::format("{} x {} pixels of {} channels are no picture", image.size.x,
                                         image.size.y, image.channels));
  }
}

/// Two channels are grey and alpha; beyond four, the rest is not colour.
FloatImage withUsualChannels(FloatImage image) {
  if (image.channels != 2) return image;
  FloatImage rgba{image.size, 4, {}};
  rgba.pixels.reserve(image.pixels.size() * 2);
  for (std::size_t i = 0; i + 1 < image.pixels.size(); i += 2) {
    const float grey = image.pixels[i];
    rgba.pixels.insert(rgba.pixels.end(), {grey, grey, grey, image.pixels[i + 1]});
  }
  return rgba;
}

FloatImage decode(const std::filesystem::path& path) {
  const SilencedStderr silence;
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(path.string(), &config);
  if (!input) throw std::runtime_error(OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  FloatImage image{{spec.width, spec.height}, std::min(spec.nchannels, 4), {}};
  image.pixels.resize(std::size_t(spec.width) * std::size_t(spec.height) * std::size_t(image.channels));
  if (!input->read_image(0, 0, 0, image.channels, OIIO::TypeDesc::FLOAT, image.pixels.data())) {
    throw std::runtime_error(input->geterror());
  }
  return withUsualChannels(std::move(image));
}

/// IEC 61966-2-1.
float srgbFromLinear(float linear) {
  if (!(linear > 0.0031308f)) return 12.92f * linear;
  return 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

}  // namespace

std::optional<ImageFormat> imageFormatOf(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  if (extension == ".png") return ImageFormat::png;
  if (extension == ".exr") return ImageFormat::exr;
  return std::nullopt;
}

void writeImage(const std::filesystem::path& path, const FloatImage& image) {
  try {
    const std::optional<ImageFormat> format = imageFormatOf(path);
    if (!format) throw std::runtime_error("its name must end in .png or .exr");
    checkImage(image);
    checkFolder(path);
    const TemporaryFile file(path);
    writeBytes(file.path(), encode(image, writerOf(*format)));
    if (const std::error_code error = file.commit()) throw std::runtime_error(error.message());
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("can't write '{}': {}", path.string(), error.what()));
  }
}

std::vector<unsigned char> encodeJpeg(const FloatImage& image) {
  checkImage(image);
  return encode(image, {"jpeg", OIIO::TypeDesc::UINT8, "sRGB"});
}

std::vector<unsigned char> encodePng(const FloatImage& image) {
  checkImage(image);
  return encode(image, writerOf(ImageFormat::png));
}

FloatImage readImage(const std::filesystem::path& path) {
  try {
    return decode(path);
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("can't read the image '{}': {}", path.string(), error.what()));
  }
}

FloatImage encodeSrgb(FloatImage image) {
  const int colors = std::min(image.channels, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (int(i % std::size_t(image.channels)) < colors) image.pixels[i] = srgbFromLinear(image.pixels[i]);
  }
  return image;
}

}  // namespace host
