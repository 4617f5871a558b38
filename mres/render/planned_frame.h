#pragma once

#include "mres/render/passes.h"
#include "mres/settings.h"

namespace mres {

/// One frame of one effect: what is planned, and the passes that draw it. Levels count from the finest of the
/// plan.
struct PlannedFrame {
  [[nodiscard]] const PlannedLevel& level(std::size_t planned) const { return plan.levels[planned]; }
  [[nodiscard]] LevelTargets& targets(std::size_t planned) const {
    return passes.effect.targets(level(planned).index);
  }
  [[nodiscard]] const gl::Texture2D& zone(std::size_t planned) const {
    return shared.zones.zone(level(planned).index);
  }
  [[nodiscard]] bool isCoarsest(std::size_t planned) const { return planned + 1 == plan.levels.size(); }
  [[nodiscard]] bool hasMasks() const { return plan.levels.size() > 1; }
  [[nodiscard]] bool isDisjoint() const { return settings.mask.disjoint && hasMasks(); }
  /// Whether blurred masks say where levels render, as the paper has it.
  [[nodiscard]] bool isByMasks() const { return settings.technique == Technique::paper; }
  /// The difference between levels that a finer level is rendered for.
  [[nodiscard]] float refineThreshold() const;
  [[nodiscard]] LevelRole roleOf(std::size_t planned) const;
  [[nodiscard]] ZoneRule zoneRuleOf(std::size_t planned) const;
  [[nodiscard]] ZoneInputs zoneInputs(std::size_t planned) const;

  /// Makes the targets and uploads the blocks of all levels.
  void prepareLevels() const;

  PassContext& context;
  const Settings& settings;
  const LevelPlan& plan;
  SharedPasses& shared;
  EffectPasses& passes;
  bool measureCoverage = false;
};

}  // namespace mres
