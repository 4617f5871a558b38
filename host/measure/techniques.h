// The techniques that users choose from by name: mres's own, and the peers that it is measured against.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mres/settings.h"

namespace host {

inline constexpr const char* kFullTechnique = "full";
inline constexpr const char* kPaperTechnique = "mres-paper";
inline constexpr const char* kMinMaxTechnique = "mres-min-max";
inline constexpr const char* kMresTechnique = "mres";
inline constexpr const char* kAdaptiveTilesTechnique = "adaptive-tiles";

struct TechniqueChoice {
  std::string name;
  std::string meaning;                 ///< for the middle of a sentence
  std::optional<mres::Technique> own;  ///< nothing: a peer of that name (host/peers/peer_kinds.h)
  bool minMaxMips = false;             ///< of mres's own: MaskSettings::minMaxMips, whatever the settings say
};

/// mres's own, then the peers.
const std::vector<TechniqueChoice>& techniques();
const std::vector<std::string>& techniqueNames();

/// Throws std::out_of_range for unknown names.
const TechniqueChoice& techniqueOf(std::string_view name);

/// Whether its picture depends on mres::MaskSettings::errorBudget.
bool heedsErrorBudget(std::string_view name);

}  // namespace host
