#include "host/measure/techniques.h"

#include <algorithm>
#include <stdexcept>

#include "host/peers/peer_kinds.h"

namespace host {
namespace {

std::vector<TechniqueChoice> makeTechniques() {
  std::vector<TechniqueChoice> all{
      {kFullTechnique, "every pixel", mres::Technique::full},
      {kPaperTechnique, "levels as the paper chooses them, by blurred masks", mres::Technique::paper},
      {kMinMaxTechnique, "mres with geometry's edges by min/max mips, as Nichols and Wyman find them",
       mres::Technique::multiResolution, true},
      {kMresTechnique, "each part at the resolution that it needs", mres::Technique::multiResolution}};
  for (const PeerKind& peer : peerKinds()) all.push_back({peer.name, peer.meaning, std::nullopt});
  return all;
}

}  // namespace

const std::vector<TechniqueChoice>& techniques() {
  static const std::vector<TechniqueChoice> kTechniques = makeTechniques();
  return kTechniques;
}

const std::vector<std::string>& techniqueNames() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const TechniqueChoice& choice : techniques()) names.push_back(choice.name);
    return names;
  }();
  return kNames;
}

const TechniqueChoice& techniqueOf(std::string_view name) {
  const auto found = std::ranges::find(techniques(), name, &TechniqueChoice::name);
  if (found == techniques().end())
    throw std::out_of_range("There is no technique '" + std::string(name) + "'.");
  return *found;
}

bool heedsErrorBudget(std::string_view name) {
  return name == kMresTechnique || name == kMinMaxTechnique || name == kAdaptiveTilesTechnique;
}

}  // namespace host
