// What an effect implements to be accelerated: one GLSL function and one small class.
#pragma once

#include <array>
#include <cstddef>
#include <epoxy/gl.h>
#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "mres/frame.h"
#include "mres/gl/program.h"
#include "mres/gl/shader_library.h"
#include "mres/settings.h"

namespace mres {

/// Full, half, quarter and eighth resolution; level i has ceil(size / 2^i) pixels.
inline constexpr int kMaxLevels = 4;

/// How one resolution level takes part (Table 1 of Besenthal, Maisch and Ropinski 2019).
struct LevelSettings {
  bool used = true;  ///< The coarsest used level renders the whole screen. Level 0 always is.
  /// Of Technique::paper: sigma^2 in pixels^2 of this level, [0, 64]. Widens the zone around edges.
  float maskVariance = 0.0f;
  /// Of Technique::paper: w_i of equation 1, [1, 1000]. Larger is a harder transition.
  float blendWeight = 1.0f;
  /// Pixels of this level, [1, 4], after which what is random repeats. The filter reaches that far, at coarse
  /// levels over more of the screen: a shorter period blurs less. The effects that come with mres have evenly
  /// spread rotations for 1, 2 and 4. Coarse levels of even periods also take turns in which of the four
  /// pixels around a block's centre Surface::pixel is.
  int noisePeriod = 4;
};

template <class Visitor>
void visit(LevelSettings& settings, Visitor&& visitor) {
  visitor("used", settings.used,
          SettingInfo{"", 0.0, 1.0, "Whether the level takes part; level 0 always does."});
  visitor(
      "maskVariance", settings.maskVariance,
      SettingInfo{"pixels^2", 0.0, 64.0, "By the paper's technique, widens the level's zone around edges."});
  visitor("blendWeight", settings.blendWeight,
          SettingInfo{"", 1.0, 1000.0,
                      "By the paper's technique, larger is a harder transition to the next coarser level."});
  visitor("noisePeriod", settings.noisePeriod,
          SettingInfo{"pixels", 1.0, 4.0, "After how many of the level's pixels what is random repeats."});
}

/// What an effect is at every pixel, and why: a string literal such as "there is no light".
struct Constant {
  glm::vec4 value{0.0f};
  const char* reason = "";
};

using LevelTable = std::array<LevelSettings, kMaxLevels>;

/// The constant part of an effect.
struct EffectDescription {
  const char* name;  ///< Unique among the effects that one MultiResolution renders, e.g. "ssao".
  /// Shader file that defines `vec4 shade(Surface surface)`; see shaders/mres/surface.glsl. Where it returns
  /// a NaN or an infinity the picture gets the background's value.
  const char* shader;
  std::span<const gl::ShaderFile> shaders;  ///< Files that `shader` needs beyond those of mres.
  /// 1 (result GL_R16F): a value from 0 to 1; values differ by |a - b|. 3 (result GL_RGBA16F): radiances, not
  /// negative, the picture's white near 1; they differ by Michelson's contrast of the largest channels,
  /// |a - b| / max(a + b, 0.1).
  int channels = 1;
  glm::vec4 background{1.0f};  ///< Effect::background(), unless that says otherwise.
  /// What is random in shade() depends on Surface::noisePixel alone, which repeats every
  /// LevelSettings::noisePeriod pixels; the depth-aware filter takes the mean over these. False: no filter.
  bool filtered = true;
  /// Wants the mips of view depth, `uniform sampler2D depthPyramid`, read by texelFetch(): texel t of mip m
  /// is the view depth of full-resolution pixel t * 2^m + 2^m / 2, 1e18 where there is no surface. Mip m has
  /// max(size >> m, 1) texels, and there are `pyramidLevels` of them (shaders/mres/frame_params.h).
  bool readsPyramid = true;
  /// `shader` also defines `vec2 preview(Surface surface)`, cheaply: the least and the largest value, 0..1,
  /// that shade() may have there. The masks are then made of its edges; MaskSettings::geometryAlways adds
  /// geometry's.
  bool hasPreview = false;
};

/// Where an effect puts its own resources for a draw; lower units and bindings are taken by mres.
inline constexpr GLuint kEffectTextureUnit = 6;   ///< 6..11 are the effect's
inline constexpr GLuint kEffectBlockBinding = 3;  ///< 3..4 are the effect's

class Effect {
 public:
  Effect() = default;
  Effect(const Effect&) = delete;
  Effect& operator=(const Effect&) = delete;
  virtual ~Effect() = default;

  [[nodiscard]] virtual const EffectDescription& description() const = 0;
  [[nodiscard]] virtual const LevelTable& levels() const = 0;

  /// Called once for all effects of one name, on the first that is rendered, and again after
  /// MultiResolution::reloadShaders(): binds the effect's samplers and blocks by name. `program` is linked
  /// and in use. Keep nothing of it in the effect: an equal one renders with it, too.
  virtual void setUp(const gl::Program& program) = 0;

  /// Called before the draws of a frame: uploads the effect's settings, binds its textures and blocks, and
  /// may draw into targets of its own; the state guard covers that. May throw std::invalid_argument, which
  /// MultiResolution::render() passes on with the host's state put back.
  virtual void bind(const Frame& frame) = 0;

  /// The value where there is no surface, in this frame. Where detail is too thin for a coarse level, it
  /// takes part of its value from what lies behind: let that be what the effect is in the open.
  [[nodiscard]] virtual glm::vec4 background() const { return description().background; }

  /// If the effect's settings and inputs make it the same at every pixel, exactly, background included: then
  /// nothing is rendered.
  [[nodiscard]] virtual std::optional<Constant> constant() const { return std::nullopt; }

  /// Of GPU memory that the effect itself holds, such as targets that bind() draws into.
  [[nodiscard]] virtual std::size_t bytes() const { return 0; }
};

}  // namespace mres
