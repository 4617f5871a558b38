#pragma once

#include <memory>
#include <optional>

#include "mres/effect.h"
#include "mres/settings.h"

namespace mres {

inline constexpr int kMaxSoftShadowSamples = 1024;

/// Table 1, column SSM; coarse levels repeat their noise every two pixels.
inline constexpr LevelTable kSoftShadowLevels = {
    {{true, 0.924f, 1000.0f}, {true, 1.848f, 1000.0f, 2}, {true, 3.696f, 1000.0f, 2}, {true, 0.0f, 1.0f, 2}}};

struct SoftShadowSettings {
  int samples = 196;              ///< 1..1024. Texels of the shadow map that are compared for each pixel.
  float filterRadius = 0.06f;     ///< metres, [0, 10]. Radius of the penumbra; with PCSS the largest one.
  bool contactHardening = false;  ///< PCSS: the penumbra widens with the distance from the blocker.
  /// degrees, [0, 90]. Diameter of a parallel light in the sky; the sun's. PCSS only.
  float lightAngle = 0.53f;
  float lightRadius = 0.05f;  ///< metres, [0, 10]. Radius of a spot light. PCSS only.
  /// share of the filter's radius, [0, 1]. Lower rises over the tangent plane cast no shadow.
  float bias = 0.1f;
  int seed = 0;  ///< [0, 65535]. Turns the samples.
  LevelTable levels = kSoftShadowLevels;
};

template <class Visitor>
void visit(SoftShadowSettings& settings, Visitor&& visitor) {
  visitor("samples", settings.samples,
          SettingInfo{"", 1.0, kMaxSoftShadowSamples, "Texels of the shadow map compared for each pixel."});
  visitor("filterRadius", settings.filterRadius,
          SettingInfo{"metres", 0.0, 10.0, "Radius of the penumbra; with contactHardening the largest one."});
  visitor("contactHardening", settings.contactHardening,
          SettingInfo{"", 0.0, 1.0, "PCSS: the penumbra widens with the distance from the blocker."});
  visitor("lightAngle", settings.lightAngle,
          SettingInfo{"degrees", 0.0, 90.0, "Diameter of a parallel light in the sky, for PCSS."});
  visitor("lightRadius", settings.lightRadius,
          SettingInfo{"metres", 0.0, 10.0, "Radius of a spot light, for PCSS."});
  visitor("bias", settings.bias,
          SettingInfo{"radii", 0.0, 1.0, "Lower rises over the tangent plane cast no shadow."});
  visitor("seed", settings.seed, SettingInfo{"", 0.0, 65535.0, "Turns the samples."});
}

/// How large the light is for PCSS: of parallel light the tangent of half its diameter in the sky, metres of
/// penumbra for each between blocker and receiver; of a spot light its radius in metres.
float lightExtent(const SoftShadowSettings& settings, bool parallel);

/// What the host hands over each frame. render() throws std::invalid_argument for a texture that is not as
/// told here. The shadow map stays the host's.
struct ShadowInputs {
  GLuint shadowMap = 0;   ///< GL_TEXTURE_2D, any depth format; smaller depths are nearer to the light
  glm::ivec2 mapSize{0};  ///< texels, 1..16384 each
  /// view space to texture coordinates and window depth of the map, 0..1 after division by w; orthographic
  /// for parallel light, else a perspective from the light
  glm::mat4 shadowFromView{1.0f};
  /// view space: unit direction to a parallel light and w = 0, or the position of a spot light and w = 1
  glm::vec4 light{0.0f, 1.0f, 0.0f, 0.0f};
};

/// Soft shadow mapping: the share of a light that each pixel sees, 0 to 1, by percentage-closer filtering or,
/// with contactHardening, percentage-closer soft shadows. Surfaces that face away from the light are 0; what
/// the map does not cover is 1.
class SoftShadows final : public Effect {
 public:
  /// Needs a current OpenGL context. Throws std::invalid_argument if a setting is out of range.
  explicit SoftShadows(const SoftShadowSettings& settings = {});
  ~SoftShadows() override;
  SoftShadows(const SoftShadows&) = delete;
  SoftShadows& operator=(const SoftShadows&) = delete;
  SoftShadows(SoftShadows&&) = delete;
  SoftShadows& operator=(SoftShadows&&) = delete;

  [[nodiscard]] const SoftShadowSettings& settings() const { return settings_; }
  void setSettings(const SoftShadowSettings& settings);

  /// Before each frame whose light, map or camera changed. Throws std::invalid_argument with a sentence.
  void setInputs(const ShadowInputs& inputs);

  [[nodiscard]] const EffectDescription& description() const override;
  [[nodiscard]] const LevelTable& levels() const override { return settings_.levels; }
  void setUp(const gl::Program& program) override;
  void bind(const Frame& frame) override;
  [[nodiscard]] std::optional<Constant> constant() const override;

 private:
  struct Resources;

  SoftShadowSettings settings_;
  ShadowInputs inputs_;
  std::unique_ptr<Resources> resources_;  // keeps the header that C++ and GLSL share out of users' files
  bool samplesUploaded_ = false;
};

}  // namespace mres
