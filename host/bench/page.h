#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "host/bench/plots.h"
#include "host/measure/picture_names.h"
#include "host/measure/report.h"

namespace host {

/// A file of report_page/, embedded.
struct PageFile {
  std::string_view name;
  std::string_view text;
};

/// The pictures that the page shows of a view, and of a worst place.
inline constexpr std::array kViewPictures{kFullPicture,       kMresPicture,       kFullEffectPicture,
                                          kMresEffectPicture, kDifferencePicture, kLevelsPicture};
inline constexpr std::array kWorstPlacePictures{kWorstFullPicture, kWorstMresPicture, kWorstFullEffectPicture,
                                                kWorstMresEffectPicture};

/// The report as a web page that needs no other file: summary, plots, pictures, table and settings. `plots`,
/// and the pictures that the report names, are relative to `folder`; of pictures that are gone, nothing is
/// shown.
std::string makePage(const Json& report, const std::vector<Plot>& plots, const std::filesystem::path& folder);

}  // namespace host
