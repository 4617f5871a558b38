#pragma once

#include <memory>
#include <optional>

#include "mres/effect.h"
#include "mres/settings.h"

namespace mres {

inline constexpr int kMaxSsaoSamples = 256;

/// Table 1 of Besenthal, Maisch and Ropinski 2019, column SSAO.
inline constexpr LevelTable kSsaoLevels = {
    {{true, 0.924f, 100.0f}, {true, 1.848f, 50.0f, 2}, {true, 3.696f, 20.0f, 2}, {true, 0.0f, 1.0f, 2}}};

struct SsaoSettings {
  float radius = 0.5f;     ///< metres, [0, 100]. Reach of the occlusion.
  int samples = 64;        ///< 1..256. Points per pixel; a pattern of rotations multiplies them.
  float intensity = 1.0f;  ///< [0, 4]. Multiplies the occlusion.
  float bias = 0.02f;  ///< share of the radius, [0, 1]. Lower rises over the tangent plane do not occlude.
  int seed = 0;        ///< [0, 65535]. Chooses the point set.
  LevelTable levels = kSsaoLevels;
};

template <class Visitor>
void visit(SsaoSettings& settings, Visitor&& visitor) {
  visitor("radius", settings.radius, SettingInfo{"metres", 0.0, 100.0, "Reach of the occlusion."});
  visitor("samples", settings.samples, SettingInfo{"", 1.0, kMaxSsaoSamples, "Points per pixel."});
  visitor("intensity", settings.intensity, SettingInfo{"", 0.0, 4.0, "Multiplies the occlusion."});
  visitor("bias", settings.bias,
          SettingInfo{"radii", 0.0, 1.0, "Lower rises over the tangent plane do not occlude."});
  visitor("seed", settings.seed, SettingInfo{"", 0.0, 65535.0, "Chooses the point set."});
}

/// Screen-space ambient occlusion: the share of the hemisphere's points that nothing hides, 0 (closed in) to
/// 1 (open).
class Ssao final : public Effect {
 public:
  /// Needs the OpenGL context of its MultiResolution current, as does the destructor. Throws
  /// std::invalid_argument if a setting is out of range.
  explicit Ssao(const SsaoSettings& settings = {});
  ~Ssao() override;
  Ssao(const Ssao&) = delete;
  Ssao& operator=(const Ssao&) = delete;
  Ssao(Ssao&&) = delete;
  Ssao& operator=(Ssao&&) = delete;

  [[nodiscard]] const SsaoSettings& settings() const { return settings_; }
  void setSettings(const SsaoSettings& settings);

  [[nodiscard]] const EffectDescription& description() const override;
  [[nodiscard]] const LevelTable& levels() const override { return settings_.levels; }
  void setUp(const gl::Program& program) override;
  void bind(const Frame& frame) override;
  [[nodiscard]] std::optional<Constant> constant() const override;

 private:
  struct Block;

  SsaoSettings settings_;
  std::unique_ptr<Block> block_;  // keeps the header that C++ and GLSL share out of users' files
  bool uploaded_ = false;
};

}  // namespace mres
