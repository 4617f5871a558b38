// The bytes behind a glTF URI.
#pragma once

#include <filesystem>
#include <string>

#include "host/scene/gltf/document.h"

namespace host::gltf {

/// A whole regular file. Throws std::runtime_error with a sentence.
Bytes readFile(const std::filesystem::path& path);

/// A base64 data URI, or a file relative to `folder` (percent-encoding undone). Throws std::runtime_error.
Bytes readUri(const std::string& uri, const std::filesystem::path& folder);

/// A URI as a message should show it: data URIs can be megabytes long.
std::string abbreviated(const std::string& uri);

}  // namespace host::gltf
