#pragma once

namespace mres {

/// What a user is told about a setting. One visit() per settings struct drives command line, JSON and panels,
/// so that no name, range or meaning is spelt twice.
struct SettingInfo {
  const char* unit;  ///< "" for none
  double min;
  double max;
  const char* meaning;
};

enum class Technique {
  full,  ///< the effect at every pixel of the full resolution: the reference
  /// Levels as Besenthal, Maisch and Ropinski (2019) have them, for comparison: chosen by blurred masks of
  /// edges, before anything is rendered, and blended by equation 1.
  paper,
  multiResolution  ///< the effect at the resolution that each pixel needs, as coarser levels and edges tell
};

/// How Frame::importance and the edges make one mask.
enum MaskCombination : int {
  kCombineByMaximum,  ///< refine where either says
  kCombineByMinimum   ///< refine only where both say
};

/// Where a level is refined. Steps in depth are on the surface, not on pixels, so that they mean the same at
/// every resolution and field of view.
struct MaskSettings {
  /// The difference between levels that a finer one is rendered for, per error over the whole picture: large
  /// differences are rare. Measured with the effects that come with mres (docs/results.md).
  static constexpr float kDifferencePerError = 8.0f;

  float normalThreshold = 20.0f;  ///< degrees, [0, 180]. Neighbours' normals further apart are an edge: of
                                  ///< pixels and, for a level, of pixels of the next coarser one.
  float depthThreshold = 0.05f;   ///< metres, [0, 100]. Larger steps in depth, off a plane, are an edge.
  float errorBudget = 0.01f;      ///< [0, 1]. RMS error to accept. A finer level renders where coarser ones
                              ///< differ by more than kDifferencePerError times that; 0: edges alone decide.
  bool geometryAlways = false;  ///< Refine at geometry's edges even for effects that find edges of their own.
  bool minMaxMips = false;  ///< Find geometry's edges by min/max mips of depth and normals, for comparison.
  bool disjoint = false;    ///< Each pixel in one level alone, for comparison; as if errorBudget were 0.
  MaskCombination combination = kCombineByMaximum;  ///< of the edges with Frame::importance, if there is one
};

template <class Visitor>
void visit(MaskSettings& settings, Visitor&& visitor) {
  visitor("normalThreshold", settings.normalThreshold,
          SettingInfo{"degrees", 0.0, 180.0, "Neighbours' normals further apart are an edge."});
  visitor("depthThreshold", settings.depthThreshold,
          SettingInfo{"metres", 0.0, 100.0, "Larger steps in depth, off a plane, are an edge."});
  visitor(
      "errorBudget", settings.errorBudget,
      SettingInfo{"RMS", 0.0, 1.0,
                  "Error to accept: a finer level is rendered where coarser ones differ by more than it is "
                  "worth; 0: edges alone decide."});
  visitor(
      "geometryAlways", settings.geometryAlways,
      SettingInfo{
          "", 0.0, 1.0,
          "Refine at geometry's edges even for effects that find edges of their own, as soft shadows do."});
  visitor("minMaxMips", settings.minMaxMips,
          SettingInfo{"", 0.0, 1.0,
                      "Find geometry's edges by min/max mips of depth and normals (Nichols and Wyman 2009) "
                      "instead of derivatives, for comparison."});
  visitor("disjoint", settings.disjoint,
          SettingInfo{"", 0.0, 1.0,
                      "Render each pixel in one level alone, for comparison; what to refine is then decided "
                      "before anything is rendered, as if errorBudget were 0."});
  visitor(
      "combination", settings.combination,
      SettingInfo{"", kCombineByMaximum, kCombineByMinimum,
                  "With an importance mask: 0 refines where it or the edges say so, 1 only where both do."});
}

/// What is chosen by time.
struct PlanSettings {
  bool fallBack = true;  ///< Render the plain effect where it is known to be faster than
                         ///< Technique::multiResolution by MultiResolution::calibrate() or from timed frames.
};

template <class Visitor>
void visit(PlanSettings& settings, Visitor&& visitor) {
  visitor("fallBack", settings.fallBack,
          SettingInfo{"", 0.0, 1.0, "Render the plain effect where it is known to be faster than levels."});
}

/// Of a MultiResolution; may change from frame to frame.
struct Settings {
  Technique technique = Technique::multiResolution;
  PlanSettings plan;
  MaskSettings mask;
};

}  // namespace mres
