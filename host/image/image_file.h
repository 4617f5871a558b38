#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace host {

/// Linear floating-point pixels, rows top to bottom.
struct FloatImage {
  glm::ivec2 size{0};
  int channels = 0;           ///< 1, 3 or 4
  std::vector<float> pixels;  ///< size.x * size.y * channels
};

enum class ImageFormat { png, exr };

/// By the end of its name, in any case; nothing for what writeImage() cannot write.
std::optional<ImageFormat> imageFormatOf(const std::filesystem::path& path);

/// Writes .png (8 bits; the values, clamped to 0..1, are stored as they are: encode before) or .exr (half
/// float). The file appears whole or not at all: it is written beside its place and renamed. Throws
/// std::runtime_error with a sentence.
void writeImage(const std::filesystem::path& path, const FloatImage& image);

/// The bytes of a JPEG file of high quality, of values as writeImage() takes them for .png.
std::vector<unsigned char> encodeJpeg(const FloatImage& image);

/// The bytes of a .png file, of values as writeImage() takes them for one.
std::vector<unsigned char> encodePng(const FloatImage& image);

/// Reads any image OpenImageIO can, as floating point.
FloatImage readImage(const std::filesystem::path& path);

/// The linear-to-sRGB transfer function, per channel; alpha stays as it is.
FloatImage encodeSrgb(FloatImage image);

}  // namespace host
