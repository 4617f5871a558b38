#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/measure/measurement.h"
#include "host/measure/picture_settings.h"
#include "host/peers/peer.h"
#include "mres/gl/texture.h"

namespace host {

/// How to time stages: by timer queries on a GPU; on a software rasteriser, whose queries return before the
/// work is done, by a glFinish around every stage. Frames with those are slower than frames without, so that
/// the stages add up to more than a frame takes.
using StageClock = mres::gl::Profiler::Mode;
StageClock stageClockOf(bool softwareRasterizer);

/// One effect by one technique with targets of its own, so that two techniques can take turns without
/// allocating.
class EffectInstance {
 public:
  /// Measuring the coverage of levels costs a little: instances that are timed don't.
  enum class Coverage { unmeasured, measured };

  /// `technique` is one of techniqueNames(). Throws std::runtime_error with a sentence if the settings'
  /// importance cannot be read.
  EffectInstance(const PictureSettings& settings, const std::string& technique, Coverage coverage);

  /// Before a frame's render().
  void setInputs(const EffectInputs& inputs) { host::setInputs(*effect_, inputs); }

  [[nodiscard]] int channels() const { return effect_->description().channels; }

  /// The texture of the effect's values. The frame's importance is that of the settings.
  GLuint render(mres::Frame frame);

  void setProfiling(StageClock clock);
  /// Of the latest frame known.
  [[nodiscard]] const std::vector<mres::gl::StageTime>& stages() const;

  /// Of GPU memory, effect included.
  [[nodiscard]] std::size_t bytes() const;

  /// Of the last render(); nothing of peers.
  [[nodiscard]] mres::PlanReport plan() const;

  /// Adds what the last render() needed: plan, coverage, skips and bytes, or a peer's work.
  void describe(Measurement& measurement) const;

  /// Null where a peer renders.
  mres::MultiResolution* multiResolution() { return multiResolution_ ? &*multiResolution_ : nullptr; }

  /// What the frame takes on this device, so that the faster plan renders; none where there is no choice.
  std::optional<mres::Costs> calibrate(mres::Frame frame);
  /// Takes those of an instance of the same settings; none: levels render.
  void setCosts(const std::optional<mres::Costs>& costs);

 private:
  [[nodiscard]] bool mayFallBack();

  std::unique_ptr<mres::Effect> effect_;
  std::optional<mres::MultiResolution> multiResolution_;  // or else a peer
  std::unique_ptr<Peer> peer_;
  mres::gl::Texture2D importance_;
};

/// What the renderer drew last, as mres wants it.
mres::Frame frameOf(const Renderer& renderer, const GBufferTextures& gbuffer, glm::ivec2 size);

/// Adds to `measurement` what a frame needs: the share of each level's pixels in which the effect runs, the
/// bytes, and each stage's time unless `clock` is off. `instance` must measure coverage.
void inspect(EffectInstance& instance, const mres::Frame& frame, StageClock clock, Measurement& measurement);

}  // namespace host
