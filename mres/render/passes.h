#pragma once

#include <utility>

#include "mres/composite/composite_pass.h"
#include "mres/composite/disjoint_pass.h"
#include "mres/level/coverage.h"
#include "mres/level/depth_pyramid.h"
#include "mres/level/effect_pass.h"
#include "mres/mask/edge_pass.h"
#include "mres/mask/importance_pass.h"
#include "mres/mask/mask_pass.h"
#include "mres/mask/min_max_pass.h"
#include "mres/mask/preview_pass.h"
#include "mres/mask/zone_pass.h"
#include "mres/plan/plan_chooser.h"

namespace mres {

/// The passes that all effects share; compiled together, so that a reload replaces all or none.
struct SharedPasses {
  explicit SharedPasses(const gl::ShaderLibrary& library)
      : pyramid(library),
        edges(library),
        minMax(library),
        importance(library),
        masks(library),
        zones(library),
        disjoint(library) {}

  void fill(float value) const {
    pyramid.fill(value);
    edges.fill(value);
    minMax.fill(value);
    importance.fill(value);
    masks.fill(value);
    zones.fill(value);
  }

  [[nodiscard]] std::size_t bytes() const {
    return pyramid.bytes() + edges.bytes() + minMax.bytes() + importance.bytes() + masks.bytes() +
           zones.bytes();
  }

  DepthPyramid pyramid;
  EdgePass edges;
  MinMaxPass minMax;
  ImportancePass importance;
  MaskPass masks;
  ZonePass zones;
  DisjointPass disjoint;
};

/// What a reload compiles of an effect before anything is replaced.
struct EffectPrograms {
  gl::Program effect;
  PreviewPass preview;
  CompositePass composite;
};

/// The passes of one effect.
struct EffectPasses {
  EffectPasses(const gl::ShaderLibrary& library, const EffectDescription& description)
      : effect(library, description), preview(library, description), composite(library, description) {}

  void setUp(Effect& with) {
    effect.expectSame(with);
    effect.setUp(with);
    preview.setUp(with);
  }

  [[nodiscard]] EffectPrograms compile(const gl::ShaderLibrary& library) const {
    return {effect.compile(library), PreviewPass(library, effect.effect()),
            CompositePass(library, effect.effect())};
  }

  void replace(EffectPrograms programs) {
    effect.setProgram(std::move(programs.effect));
    preview = std::move(programs.preview);
    composite = std::move(programs.composite);
  }

  void fill(float value) const {
    effect.fillTargets(value);
    preview.fill(value);
  }

  [[nodiscard]] std::size_t bytes() const { return effect.bytes() + preview.bytes(); }

  EffectPass effect;
  PreviewPass preview;
  CompositePass composite;
  CoverageQueries coverage;
  PlanChooser chooser;
};

}  // namespace mres
