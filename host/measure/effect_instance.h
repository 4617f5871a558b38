#pragma once

#include <memory>
#include <optional>

#include "host/measure/measurement.h"
#include "host/measure/picture_settings.h"
#include "mres/gl/texture.h"

namespace host {

/// One effect by one technique with targets of its own, so that two techniques can take turns without
/// allocating.
class EffectInstance {
 public:
  /// Measuring the coverage of levels costs a little: instances that are timed don't.
  enum class Coverage { unmeasured, measured };

  /// Throws std::runtime_error with a sentence if the settings' importance cannot be read.
  EffectInstance(const PictureSettings& settings, mres::Technique technique, Coverage coverage);

  /// Before a frame's render().
  void setInputs(const EffectInputs& inputs) { host::setInputs(*effect_, inputs); }

  [[nodiscard]] int channels() const { return effect_->description().channels; }

  /// The texture of the effect's values. The frame's importance is that of the settings.
  GLuint render(mres::Frame frame);
  mres::MultiResolution& multiResolution() { return multiResolution_; }

  /// What the frame takes on this device, so that the faster plan renders; none where there is no choice.
  std::optional<mres::Costs> calibrate(mres::Frame frame);
  /// Takes those of an instance of the same settings; none: levels render.
  void setCosts(const std::optional<mres::Costs>& costs) { multiResolution_.setCosts(*effect_, costs); }

 private:
  [[nodiscard]] bool mayFallBack();

  std::unique_ptr<mres::Effect> effect_;
  mres::MultiResolution multiResolution_;
  mres::gl::Texture2D importance_;
};

/// What the renderer drew last, as mres wants it.
mres::Frame frameOf(const Renderer& renderer, const GBufferTextures& gbuffer, glm::ivec2 size);

/// How to time stages: by timer queries on a GPU; on a software rasteriser, whose queries return before the
/// work is done, by a glFinish around every stage. Frames with those are slower than frames without, so that
/// the stages add up to more than a frame takes.
using StageClock = mres::gl::Profiler::Mode;
StageClock stageClockOf(bool softwareRasterizer);

/// Adds to `measurement` what a frame needs: the share of each level's pixels in which the effect runs, the
/// bytes, and each stage's time unless `clock` is off. `instance` must measure coverage.
void inspect(EffectInstance& instance, const mres::Frame& frame, StageClock clock, Measurement& measurement);

}  // namespace host
