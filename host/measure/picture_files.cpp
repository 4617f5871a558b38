#include "host/measure/picture_files.h"

#include <array>

#include "host/image/crop.h"

namespace host {
namespace {

struct PictureFile {
  const char* subject;
  const char* file;
  FloatImage ComparisonPictures::*picture;
};

constexpr std::array<PictureFile, 9> kFiles{{
    {"full", "full.png", &ComparisonPictures::reference},
    {"mres", "mres.png", &ComparisonPictures::technique},
    {"effect_full", "effect_full.png", &ComparisonPictures::referenceEffect},
    {"effect_mres", "effect_mres.png", &ComparisonPictures::techniqueEffect},
    {"effect_full_values", "effect_full.exr", &ComparisonPictures::referenceEffect},
    {"effect_mres_values", "effect_mres.exr", &ComparisonPictures::techniqueEffect},
    {"difference", "difference.png", &ComparisonPictures::difference},
    {"edges", "edges.png", &ComparisonPictures::edges},
    {"levels", "levels.png", &ComparisonPictures::levels},
}};

constexpr std::array<PictureFile, 4> kWorstPlaceFiles{{
    {"worst_full", "worst_full.png", &ComparisonPictures::reference},
    {"worst_mres", "worst_mres.png", &ComparisonPictures::technique},
    {"worst_effect_full", "worst_effect_full.png", &ComparisonPictures::referenceEffect},
    {"worst_effect_mres", "worst_effect_mres.png", &ComparisonPictures::techniqueEffect},
}};

}  // namespace

Json writePictures(const ComparisonPictures& pictures, const std::filesystem::path& directory,
                   const FileObserver& observe) {
  Json names = Json::object();
  for (const PictureFile& entry : kFiles) {
    if (observe) observe(entry.file);
    writeImage(directory / entry.file, pictures.*entry.picture);
    names[entry.subject] = entry.file;
  }
  names["difference_enhancement"] = kDifferenceEnhancement;
  return names;
}

Json writeWorstPlace(const ComparisonPictures& pictures, glm::ivec2 place,
                     const std::filesystem::path& directory) {
  constexpr int kSide = 256;
  Json names = Json::object();
  for (const PictureFile& entry : kWorstPlaceFiles) {
    writeImage(directory / entry.file, cropAround(pictures.*entry.picture, place, kSide));
    names[entry.subject] = entry.file;
  }
  return names;
}

Json picturesBelow(const std::filesystem::path& folder, Json pictures) {
  for (auto& [subject, file] : pictures.items())
    if (file.is_string()) file = (folder / file.get<std::string>()).generic_string();
  return pictures;
}

}  // namespace host
