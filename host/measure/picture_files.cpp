#include "host/measure/picture_files.h"

#include <array>

#include "host/image/crop.h"
#include "host/measure/picture_names.h"

namespace host {
namespace {

struct PictureFile {
  const char* subject;
  const char* file;
  FloatImage ComparisonPictures::*picture;
};

constexpr std::array<PictureFile, 9> kFiles{{
    {kFullPicture, "full.png", &ComparisonPictures::reference},
    {kMresPicture, "mres.png", &ComparisonPictures::technique},
    {kFullEffectPicture, "effect_full.png", &ComparisonPictures::referenceEffect},
    {kMresEffectPicture, "effect_mres.png", &ComparisonPictures::techniqueEffect},
    {kFullEffectValues, "effect_full.exr", &ComparisonPictures::referenceEffect},
    {kMresEffectValues, "effect_mres.exr", &ComparisonPictures::techniqueEffect},
    {kDifferencePicture, "difference.png", &ComparisonPictures::difference},
    {kEdgesPicture, "edges.png", &ComparisonPictures::edges},
    {kLevelsPicture, "levels.png", &ComparisonPictures::levels},
}};

constexpr std::array<PictureFile, 4> kWorstPlaceFiles{{
    {kWorstFullPicture, "worst_full.png", &ComparisonPictures::reference},
    {kWorstMresPicture, "worst_mres.png", &ComparisonPictures::technique},
    {kWorstFullEffectPicture, "worst_effect_full.png", &ComparisonPictures::referenceEffect},
    {kWorstMresEffectPicture, "worst_effect_mres.png", &ComparisonPictures::techniqueEffect},
}};

}  // namespace

Json writePictures(const ComparisonPictures& pictures, const std::filesystem::path& directory,
                   const FileObserver& observe) {
  Json names = Json::object();
  for (const PictureFile& entry : kFiles) {
    if ((pictures.*entry.picture).pixels.empty()) continue;  // not every technique has them all
    if (observe) observe(entry.file);
    writeImage(directory / entry.file, pictures.*entry.picture);
    names[entry.subject] = entry.file;
  }
  names[kDifferenceEnhancementName] = kDifferenceEnhancement;
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
