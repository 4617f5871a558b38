#pragma once

#include <filesystem>
#include <string>

namespace host {

/// A file of a media type such as "image/svg+xml" as a URI that holds it, for pages that are one file (RFC
/// 2397). Throws std::runtime_error with a sentence.
std::string dataUri(const std::filesystem::path& file, const std::string& mediaType);

/// Any picture, as a JPEG that is hard to tell from it.
std::string jpegDataUri(const std::filesystem::path& picture);

}  // namespace host
