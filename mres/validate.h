#pragma once

#include "mres/effect.h"
#include "mres/settings.h"

namespace mres {

/// Throws std::invalid_argument with a sentence that tells the setting and its range.
[[noreturn]] void refuseSetting(const char* owner, const char* name, const SettingInfo& info);

/// Refuses settings outside of the ranges that their visit() tells; NaN is in no range. `owner` is the
/// struct's name, for the message.
template <class Settings>
void validate(const char* owner, Settings settings) {
  visit(settings, [owner](const char* name, auto value, const SettingInfo& info) {
    const auto number = static_cast<double>(value);
    if (!(number >= info.min && number <= info.max)) refuseSetting(owner, name, info);
  });
}

/// 1 to 16384 in each direction.
bool isTextureSize(glm::ivec2 size);

bool isFinite(const glm::mat4& matrix);

inline void validate(const LevelTable& levels) {
  for (const LevelSettings& level : levels) validate("LevelSettings", level);
}

}  // namespace mres
