#include "host/truth/quarter_effect.h"

#include <utility>

namespace host {
namespace {

constexpr mres::LevelSettings kUsed{};
constexpr mres::LevelSettings kUnused{.used = false};
constexpr mres::LevelTable kFullAndQuarter{{kUsed, kUnused, kUsed, kUnused}};

}  // namespace

QuarterEffect::QuarterEffect(std::unique_ptr<mres::Effect> effect)
    : effect_(std::move(effect)), description_(effect_->description()) {
  description_.filtered = false;
  description_.hasPreview = false;  // edges of its own would be sought for nothing
}

const mres::LevelTable& QuarterEffect::levels() const {
  return kFullAndQuarter;
}

}  // namespace host
