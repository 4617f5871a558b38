#pragma once

#include <filesystem>
#include <functional>

#include "host/measure/comparison.h"

namespace host {

/// Called with the name of each file before it is written.
using FileObserver = std::function<void(const std::string& name)>;

/// Writes the pictures that there are into `directory`, which exists, each file whole or not at all. Returns
/// what each shows and its file name, for a report.
Json writePictures(const ComparisonPictures& pictures, const std::filesystem::path& directory,
                   const FileObserver& observe = {});

/// Writes what lies around the place where the pictures differ most, 256x256 pixels of it, into `directory`,
/// and returns what for a report.
Json writeWorstPlace(const ComparisonPictures& pictures, glm::ivec2 place,
                     const std::filesystem::path& directory);

/// The same, with file names relative to the parent of `folder`.
Json picturesBelow(const std::filesystem::path& folder, Json pictures);

}  // namespace host
