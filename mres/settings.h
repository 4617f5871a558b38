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
  full,            ///< the effect at every pixel of the full resolution: the reference
  multiResolution  ///< the effect at the resolution that each pixel needs
};

/// Where the edge detector sees detail. Thresholds are on the surface, not on pixels, so that they mean the
/// same at every resolution and field of view.
struct MaskSettings {
  float normalThreshold = 20.0f;  ///< degrees, [0, 180]. Normals of neighbours further apart are an edge.
  float depthThreshold =
      0.05f;  ///< metres, [0, 100]. Steps in depth off a plane larger than this are an edge.
};

template <class Visitor>
void visit(MaskSettings& settings, Visitor&& visitor) {
  visitor("normalThreshold", settings.normalThreshold,
          SettingInfo{"degrees", 0.0, 180.0,
                      "Normals of neighbouring pixels further apart than this are an edge."});
  visitor("depthThreshold", settings.depthThreshold,
          SettingInfo{"metres", 0.0, 100.0, "Steps in depth off a plane larger than this are an edge."});
}

/// Of a MultiResolution; may change from frame to frame.
struct Settings {
  Technique technique = Technique::multiResolution;
  MaskSettings mask;
};

}  // namespace mres
