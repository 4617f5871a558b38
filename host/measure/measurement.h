#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/measure/error_metrics.h"
#include "host/measure/interleaved.h"
#include "host/measure/picture_settings.h"
#include "host/measure/temporal_errors.h"
#include "host/scene/scene.h"

namespace host {

using Json = nlohmann::ordered_json;

struct StageCost {
  std::string name;
  double milliseconds = 0.0;
};

struct SkippedPart {
  std::string what;
  std::string reason;
};

/// How far technique and reference are from a better picture than both (see host/truth/truth.h), at some of
/// the pixels.
struct TruthErrors {
  std::string name;        ///< of the truth: "converged" or "ray_traced"
  std::string unit;        ///< what `count` counts: "samples" or "rays"
  int count = 0;           ///< for each pixel of the truth
  std::size_t pixels = 0;  ///< that were compared
  ValueErrors technique;
  ValueErrors reference;
};

/// What was measured of one picture.
struct Measurement {
  std::string scene;
  std::size_t triangles = 0;
  int camera = 0;
  std::string cameraName;
  glm::ivec2 size{0};
  std::string effect;
  int samples = 0;
  std::string technique;
  std::optional<std::string> reference;
  std::optional<int> referenceSamples;     ///< none: as many as the technique has
  Json settings;                           ///< every setting that the picture depends on
  std::optional<InterleavedTimes> times;   ///< none if pictures and errors alone were asked for; without
                                           ///< reference runs there is no speedup
  std::optional<ErrorMetrics> error;       ///< none without a reference
  std::vector<TruthErrors> truths;         ///< none if they weren't asked for
  std::optional<TemporalErrors> temporal;  ///< none if no flicker was asked for
  std::vector<double> coverage;            ///< share of level i in which the effect ran; none of peers
  /// Of peers: pixels in which the effect ran, for each of the full resolution.
  std::optional<double> work;
  std::vector<StageCost> stages;  ///< of the technique; none if no timing was asked for
  std::string stagesClock;        ///< what the stages were timed with
  std::vector<SkippedPart> skipped;
  mres::PlanReport plan;
  std::size_t gpuBytes = 0;
  double seconds = 0.0;  ///< that all of it took, writing pictures and, where it had to be, loading the scene
  Json pictures = Json::object();     ///< what a picture shows -> its file, relative to the report
  std::vector<std::string> warnings;  ///< warningsOf() it
};

/// What is known before anything is drawn.
Measurement describePicture(const Scene& scene, const PictureSettings& settings, int camera, glm::ivec2 size);

/// What users should know of a scene: what its loader left out or guessed, what the renderer cannot draw. A
/// sentence each.
std::vector<std::string> warningsOf(const Scene& scene, const Renderer& renderer);

}  // namespace host
