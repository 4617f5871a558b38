// Techniques that engines use instead of mres's, to be measured against it with the same effect, noise,
// filter and formats.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mres/effect.h"
#include "mres/frame.h"
#include "mres/gl/profiler.h"
#include "mres/settings.h"

namespace host {

/// Fixed for the life of a Peer.
struct PeerOptions {
  /// Shader files found below it win over the embedded ones. Empty: none.
  std::string shaderDirectory = {};
  /// Of those that choose resolutions: the RMS error to accept, as mres::MaskSettings has it.
  float errorBudget = mres::MaskSettings{}.errorBudget;
  bool measureWork = false;  ///< Occlusion queries around the effect where work() depends on the picture.
};

/// Renders one effect by one technique. Belongs to the OpenGL context (3.3 core or later) that is current
/// when it is made, and leaves all OpenGL state as it found it.
class Peer {
 public:
  Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  virtual ~Peer() = default;

  /// `effect` is the one that the peer was made for, or an equal one. Returns the texture of its values:
  /// GL_R16F, or GL_RGBA16F whose alpha means nothing; frame.size texels, valid until the next call. Throws
  /// as mres::MultiResolution::render() does.
  virtual GLuint render(mres::Effect& effect, const mres::Frame& frame) = 0;

  virtual void setProfiling(mres::gl::Profiler::Mode mode) = 0;
  /// Of the latest frame known; empty while profiling is off.
  [[nodiscard]] virtual const std::vector<mres::gl::StageTime>& stages() const = 0;

  /// At how many pixels the last frame evaluated the effect, as a share of those of the full resolution.
  /// Where that depends on the picture, the latest that PeerOptions::measureWork has found; until then, all.
  [[nodiscard]] virtual double work() = 0;

  /// Of GPU memory that the peer holds.
  [[nodiscard]] virtual std::size_t bytes() const = 0;

  /// Fills every texture that frames render into, e.g. with NaN, to prove that nothing undefined is read.
  virtual void fillTargets(float value) = 0;
};

}  // namespace host
