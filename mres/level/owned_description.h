#pragma once

#include <string>
#include <vector>

#include "mres/effect.h"

namespace mres {

/// A copy of an effect's description, texts included, for when the effect is gone.
class OwnedDescription {
 public:
  explicit OwnedDescription(const EffectDescription& original);
  OwnedDescription(OwnedDescription&&) noexcept = default;
  OwnedDescription& operator=(OwnedDescription&&) noexcept = default;
  OwnedDescription(const OwnedDescription&) = delete;
  OwnedDescription& operator=(const OwnedDescription&) = delete;
  ~OwnedDescription() = default;

  [[nodiscard]] const EffectDescription& get() const { return description_; }

  /// Whether the other one describes the same effect, text by text.
  [[nodiscard]] bool describes(const EffectDescription& other) const;

 private:
  std::vector<std::string> texts_;  // what the members below point into; a moved vector's strings stay put
  std::vector<gl::ShaderFile> files_;
  EffectDescription description_;
};

}  // namespace mres
