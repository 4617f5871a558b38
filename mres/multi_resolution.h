#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "mres/effect.h"
#include "mres/frame.h"
#include "mres/report.h"
#include "mres/settings.h"

namespace mres {

/// Fixed for the life of a MultiResolution.
struct Options {
  gl::Profiler::Mode profiling = gl::Profiler::Mode::off;
  /// Occlusion queries around the effect; the host must have none of its own active.
  bool measureCoverage = false;
  std::string shaderDirectory = {};  ///< Shader files found below it win over the embedded ones. Empty: none.
};

/// What debugView() shows, as RGBA8 pictures of the full resolution.
enum class DebugView {
  edges,  ///< red normals, green depth, blue the effect's own (soft shadows); folds, edges of coarse levels
          ///< alone, are not shown
  levels  ///< the finest level that renders each pixel: red full, green half, blue quarter, black eighth
};

/// Renders effects at the resolution that each part of the screen needs (Besenthal, Maisch and Ropinski,
/// "Multi-Resolution Rendering for Computationally Expensive Lighting Effects", 2019).
///
/// Belongs to the OpenGL context (3.3 core or later) current when it is made; that context must be current in
/// every call and when it is destroyed. Leaves all OpenGL state as it found it; an occlusion query of the
/// host that is active meanwhile counts what mres draws.
class MultiResolution {
 public:
  /// Throws std::runtime_error if the driver rejects a shader.
  explicit MultiResolution(const Options& options = {});
  ~MultiResolution();
  MultiResolution(const MultiResolution&) = delete;
  MultiResolution& operator=(const MultiResolution&) = delete;
  MultiResolution(MultiResolution&&) noexcept;
  MultiResolution& operator=(MultiResolution&&) noexcept;

  Settings& settings();

  /// Renders `effect` for `frame` and returns the texture of its values: GL_R16F or GL_RGBA16F, frame.size
  /// texels, valid until the next render() of an effect of the same name. Throws std::invalid_argument for a
  /// frame that cannot be rendered and settings out of range, std::logic_error for an effect that differs
  /// from an earlier one of the same name, std::runtime_error if the driver rejects a shader or a target.
  GLuint render(Effect& effect, const Frame& frame);

  /// Measures on this device what `effect` takes for `frame`, by levels and at every pixel, so that from the
  /// next render() on the faster one renders, as PlanSettings::fallBack has it. None if the effect is the
  /// same at every pixel. Costs are kept until they are measured or set again: do so when the size, the
  /// effect's samples or errorBudget have changed much, or let frames keep them up to date, by
  /// Options::profiling by queries with Options::measureCoverage (not on software rasterisers, whose queries
  /// return before the work is done).
  ///
  /// Renders and waits for some frames, a fraction of a second or, of slow ones, a few: for when a scene has
  /// been loaded, not for every frame. No occlusion query may be active. Throws what render() does; the
  /// result of the effect's last render() is overwritten.
  std::optional<Costs> calibrate(Effect& effect, const Frame& frame);

  /// Takes costs that calibrate() measured on the same device before; none forgets what is known, so that
  /// levels render. Throws what render() does if the effect is new.
  void setCosts(Effect& effect, const std::optional<Costs>& costs);

  /// What the last render() did.
  [[nodiscard]] const Report& report() const;

  /// A picture of how the last render() decided; valid until the next call. Throws std::logic_error before
  /// the first render(), and between reloadShaders() or forget() of the last effect and the next.
  GLuint debugView(DebugView view);

  /// Changes how stages are timed, from the next render() on.
  void setProfiling(gl::Profiler::Mode mode);

  /// Compiles all shaders anew, from Options::shaderDirectory where they are there. Throws std::runtime_error
  /// with the compiler's words and keeps the old ones if a shader is wrong.
  void reloadShaders();

  /// Frees the shaders and textures of an effect, the result of its last render() too. Nothing happens if
  /// there is none of that name.
  void forget(std::string_view effectName);

  /// Fills every texture that frames render into, e.g. with NaN, to prove that nothing undefined is read.
  void fillTargets(float value);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace mres
