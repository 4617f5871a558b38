#include "host/image/data_uri.h"

#include <OpenImageIO/strutil.h>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "host/image/image_file.h"

namespace host {
namespace {

std::string uriOf(const std::string& mediaType, std::string_view bytes) {
  return fmt::format("data:{};base64,{}", mediaType,
                     OIIO::Strutil::base64_encode({bytes.data(), bytes.size()}));
}

}  // namespace

std::string dataUri(const std::filesystem::path& file, const std::string& mediaType) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw std::runtime_error(fmt::format("Cannot read '{}'.", file.string()));
  return uriOf(mediaType, bytes);
}

std::string jpegDataUri(const std::filesystem::path& picture) {
  const std::vector<unsigned char> bytes = encodeJpeg(readImage(picture));
  return uriOf("image/jpeg", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace host
