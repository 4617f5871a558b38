#include "mres/level/owned_description.h"

#include <algorithm>
#include <string_view>

namespace mres {

OwnedDescription::OwnedDescription(const EffectDescription& original) : description_(original) {
  texts_.reserve(2 + 2 * original.shaders.size());  // pointers into it are taken
  const auto keep = [this](std::string_view text) -> const std::string& { return texts_.emplace_back(text); };
  description_.name = keep(original.name).c_str();
  description_.shader = keep(original.shader).c_str();
  for (const gl::ShaderFile& file : original.shaders) {
    const std::string& name = keep(file.name);
    files_.push_back({name, keep(file.text)});
  }
  description_.shaders = files_;
}

bool OwnedDescription::describes(const EffectDescription& other) const {
  const auto sameFile = [](const gl::ShaderFile& a, const gl::ShaderFile& b) {
    return a.name == b.name && a.text == b.text;
  };
  return std::string_view(description_.name) == other.name &&
         std::string_view(description_.shader) == other.shader && description_.channels == other.channels &&
         description_.background == other.background && description_.filtered == other.filtered &&
         description_.readsPyramid == other.readsPyramid && description_.hasPreview == other.hasPreview &&
         std::ranges::equal(description_.shaders, other.shaders, sameFile);
}

}  // namespace mres
