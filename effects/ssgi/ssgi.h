#pragma once

#include <memory>
#include <optional>

#include "mres/effect.h"
#include "mres/settings.h"

namespace mres {

/// Table 1 of Besenthal, Maisch and Ropinski 2019, column SSGI, and a half level like its quarter level. The
/// paper has none (level 1 not used): folds and mouldings between the quarter level's pixels then break up
/// into blocks.
inline constexpr LevelTable kSsgiLevels = {
    {{true, 0.924f, 1000.0f}, {true, 0.924f, 100.0f, 2}, {true, 0.924f, 100.0f, 2}, {true, 0.0f, 1.0f, 2}}};

struct SsgiSettings {
  float radius = 1.0f;     ///< metres, [0, 100]. Reach of the occlusion and of the bounce.
  int samples = 228;       ///< 8..8192. Points per pixel; a pattern of rotations multiplies them.
  float intensity = 1.0f;  ///< [0, 4]. Multiplies the bounce; above 1 energy is not conserved.
  float bias = 0.02f;      ///< share of the radius, [0, 1]. Lower rises over the tangent plane do not block.
  float maxRadiance = 8.0f;  ///< [0, 1000]. Of a lit pixel. One much brighter than the rest, met by few
                             ///< points, would show as noise; highlights are no diffuse light anyway.
  int seed = 0;              ///< [0, 65535]. Chooses the point set.
  LevelTable levels = kSsgiLevels;
};

template <class Visitor>
void visit(SsgiSettings& settings, Visitor&& visitor) {
  visitor("radius", settings.radius,
          SettingInfo{"metres", 0.0, 100.0, "Reach of the occlusion and of the bounce."});
  visitor("samples", settings.samples, SettingInfo{"", 8.0, 8192.0, "Points per pixel."});
  visitor("intensity", settings.intensity,
          SettingInfo{"", 0.0, 4.0, "Multiplies the bounce; above 1 energy is not conserved."});
  visitor("bias", settings.bias,
          SettingInfo{"radii", 0.0, 1.0, "Lower rises over the tangent plane do not block."});
  visitor("maxRadiance", settings.maxRadiance,
          SettingInfo{"", 0.0, 1000.0, "Brighter pixels count as this bright, so that none shows as noise."});
  visitor("seed", settings.seed, SettingInfo{"", 0.0, 65535.0, "Chooses the point set."});
}

/// What the host hands over each frame. render() throws std::invalid_argument for a texture that is not as
/// told here. Radiances are in one unit of the host's choice. The effect keeps what it needs of the lit
/// picture at half the resolution and below, 2.7 bytes for each pixel of the frame.
struct SsgiInputs {
  GLuint radiance = 0;  ///< lit picture: GL_TEXTURE_2D, float, linear, frame.size texels. 0: no bounce.
  float radianceScale = 1.0f;        ///< [0, 65504]. Multiplies the picture, e.g. exposure.
  glm::vec3 environmentAbove{0.0f};  ///< [0, 65504]. Radiance that comes from straight above; from below and
  glm::vec3 environmentBelow{0.0f};  ///< in between it is linear in the vertical component of the direction.
  glm::vec3 up{0.0f, 1.0f, 0.0f};    ///< the world's up, in view space; unit length
};

/// Screen-space directional occlusion with one bounce: the mean radiance that arrives over the
/// cosine-weighted hemisphere, irradiance / pi, in three channels. Indirect diffuse light is albedo times it.
/// Where there is no surface, what an upright one receives in the open.
class Ssgi final : public Effect {
 public:
  /// Throws std::invalid_argument if a setting is out of range.
  explicit Ssgi(const SsgiSettings& settings = {});
  ~Ssgi() override;
  Ssgi(const Ssgi&) = delete;
  Ssgi& operator=(const Ssgi&) = delete;
  Ssgi(Ssgi&&) = delete;
  Ssgi& operator=(Ssgi&&) = delete;

  [[nodiscard]] const SsgiSettings& settings() const { return settings_; }
  void setSettings(const SsgiSettings& settings);

  /// Throws std::invalid_argument if a radiance is out of range or `up` is no direction.
  void setInputs(const SsgiInputs& inputs);

  [[nodiscard]] const EffectDescription& description() const override;
  [[nodiscard]] const LevelTable& levels() const override { return settings_.levels; }
  void setUp(const gl::Program& program) override;
  void bind(const Frame& frame) override;
  [[nodiscard]] glm::vec4 background() const override;
  [[nodiscard]] std::optional<Constant> constant() const override;
  [[nodiscard]] std::size_t bytes() const override;

 private:
  struct Resources;

  SsgiSettings settings_;
  SsgiInputs inputs_;
  std::unique_ptr<Resources> resources_;  // keeps the header that C++ and GLSL share out of users' files
  bool pointsUploaded_ = false;
};

}  // namespace mres
