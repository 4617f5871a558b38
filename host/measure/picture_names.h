// What the pictures of a comparison show, as reports (report.h) call them.
#pragma once

namespace host {

inline constexpr const char* kFullPicture = "full";  ///< lit, by the reference
inline constexpr const char* kMresPicture = "mres";  ///< lit, by the technique
inline constexpr const char* kFullEffectPicture = "effect_full";
inline constexpr const char* kMresEffectPicture = "effect_mres";
inline constexpr const char* kFullEffectValues = "effect_full_values";
inline constexpr const char* kMresEffectValues = "effect_mres_values";
inline constexpr const char* kDifferencePicture = "difference";
inline constexpr const char* kEdgesPicture = "edges";
inline constexpr const char* kLevelsPicture = "levels";

/// A number beside the pictures' files.
inline constexpr const char* kDifferenceEnhancementName = "difference_enhancement";

/// Where a picture is farthest from its reference.
inline constexpr const char* kWorstFullPicture = "worst_full";
inline constexpr const char* kWorstMresPicture = "worst_mres";
inline constexpr const char* kWorstFullEffectPicture = "worst_effect_full";
inline constexpr const char* kWorstMresEffectPicture = "worst_effect_mres";

}  // namespace host
