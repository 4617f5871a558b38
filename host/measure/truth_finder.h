#pragma once

#include <optional>
#include <vector>

#include "host/measure/picture_settings.h"
#include "host/truth/converged_reference.h"
#include "host/truth/ray_scene.h"

namespace host {

/// Of the converged reference of a picture with `samples`.
int convergedSamples(int samples);

/// Finds what an effect's pictures of a scene should be, by more work than any picture may take: the effect
/// with thousands of samples and, where that is known, light itself.
class TruthFinder {
 public:
  /// `scene` must outlive this. Needs a current OpenGL context.
  TruthFinder(const Scene& scene, const PictureSettings& settings);

  /// Of a frame of the host's renderer, with what the effect reads besides. `observe` is called often enough
  /// to stop the work in between. Throws as RayScene does.
  std::vector<Truth> find(const mres::Frame& frame, const EffectInputs& inputs, const WorkObserver& observe);

 private:
  Truth converged(const mres::Frame& frame, const EffectInputs& inputs, const WorkObserver& observe);
  Truth rayTraced(const mres::Frame& frame, const EffectInputs& inputs, const WorkObserver& observe);

  const Scene& scene_;
  PictureSettings settings_;
  ConvergedReference convergedReference_;
  std::optional<RayScene> rayScene_;  // made for the first rays
};

}  // namespace host
