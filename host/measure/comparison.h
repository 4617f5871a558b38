#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/measure/camera_path.h"
#include "host/measure/effect_instance.h"
#include "host/measure/interleaved.h"
#include "host/measure/measurement.h"
#include "host/measure/truth_finder.h"
#include "host/scene/scene.h"

namespace host {

/// What to look at, and how hard.
struct ComparisonRequest {
  int camera = 0;
  glm::ivec2 size{0};
  std::optional<RepeatPlan> timing = std::nullopt;  ///< none: pictures and errors alone
  bool truth = false;  ///< whether to measure against better pictures than the reference, too
  std::optional<CameraPath> path = std::nullopt;  ///< none: no flicker is measured
  bool stages = true;  ///< whether to look at coverage and at each stage, which takes frames of its own
};

/// The pictures of a comparison, encoded for display but for the effect's values.
struct ComparisonPictures {
  FloatImage reference;        ///< lit by the reference
  FloatImage technique;        ///< lit by the technique
  FloatImage referenceEffect;  ///< the effect's values; see error_metrics.h
  FloatImage techniqueEffect;
  FloatImage difference;  ///< of the effect's values, kDifferenceEnhancement times enhanced
  // Of mres's own techniques; empty for peers.
  FloatImage edges;   ///< red normals, green depth, blue what the effect finds itself, e.g. shadows
  FloatImage levels;  ///< the finest level at each pixel: red full, green half, blue quarter, black eighth
};

inline constexpr float kDifferenceEnhancement = 8.0f;

/// Measures a technique against the effect at full resolution, on the effect's values and nothing else: the
/// G-buffer is drawn before, the lighting after.
class Comparison {
 public:
  /// `scene` must outlive the comparison.
  Comparison(const Scene& scene, const PictureSettings& settings, bool softwareRasterizer)
      : Comparison(scene, settings, settings, softwareRasterizer) {}
  /// `reference` may differ from `settings` in the effect's own alone.
  Comparison(const Scene& scene, const PictureSettings& settings, const PictureSettings& reference,
             bool softwareRasterizer);

  Measurement measure(
      const ComparisonRequest& request, const WorkObserver& observe = [](auto&&...) {});

  /// What users should know of the scene.
  [[nodiscard]] std::vector<std::string> warnings() const { return warningsOf(scene_, renderer_); }

  /// Of what measure() was last asked.
  ComparisonPictures pictures();

 private:
  void draw(const Camera& camera, glm::ivec2 size);
  void setCosts(const std::optional<mres::Costs>& costs);
  void render(const ComparisonRequest& request, Measurement& measurement, const WorkObserver& observe);
  void renderTechnique() { techniqueTexture_ = technique_.render(frame_); }
  void renderReference() { referenceTexture_ = reference_.render(frame_); }
  void readValues();
  Measurement measureView(const ComparisonRequest& request, const WorkObserver& observe);
  TemporalErrors measureFlicker(const ComparisonRequest& request, const WorkObserver& observe);
  void look(const ComparisonRequest& request, Measurement& measurement, const WorkObserver& observe);
  std::vector<TruthErrors> compareWithTruths(const WorkObserver& observe);
  FloatImage litBy(GLuint effect);

  const Scene& scene_;
  PictureSettings settings_;
  PictureSettings referenceSettings_;
  bool softwareRasterizer_;
  mres::gl::Profiler profiler_;
  Renderer renderer_;
  EffectInstance technique_;
  EffectInstance reference_;
  EffectInstance inspected_;
  std::unique_ptr<TruthFinder> truthFinder_;  // made when it is first asked for
  mres::Frame frame_;
  EffectInputs inputs_;
  GLuint techniqueTexture_ = 0;
  GLuint referenceTexture_ = 0;
  FloatImage techniqueValues_;
  FloatImage referenceValues_;
};

}  // namespace host
