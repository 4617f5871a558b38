// One scope object = one debug group + one timed stage, with the same name in a frame debugger, on the HUD
// and in the JSON.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string_view>
#include <vector>

#include "mres/gl/object.h"

namespace mres::gl {

struct StageTime {
  std::string_view name;  ///< a string literal
  double milliseconds = 0.0;
};

/// Times the scopes of a frame.
class Profiler {
 public:
  enum class Mode {
    off,    ///< debug groups only
    query,  ///< GL_TIMESTAMP queries, read some frames later, never waited for
    finish  ///< glFinish and a monotonic clock around each scope: the truth on llvmpipe, but it stalls
  };

  explicit Profiler(Mode mode = Mode::off);
  void setMode(Mode mode) { nextMode_ = mode; }
  [[nodiscard]] Mode mode() const { return mode_; }
  /// The mode from the next beginFrame() on.
  [[nodiscard]] Mode nextMode() const { return nextMode_; }

  /// Frames the scopes of one picture; a change of mode takes effect at beginFrame(). `frame` is a name for
  /// it.
  void beginFrame(std::uint64_t frame = 0);
  void endFrame();
  /// The latest frame whose times are known, in the order in which the scopes began; empty while there is
  /// none of the present mode.
  [[nodiscard]] const std::vector<StageTime>& stages() const { return stages_; }
  /// What beginFrame() was given for it.
  [[nodiscard]] std::uint64_t stagesFrame() const { return stagesFrame_; }

 private:
  friend class Scope;
  static constexpr int kFramesInFlight = 4;
  struct Pending {
    std::string_view name;
    QueryName begin;
    QueryName end;
  };
  struct FrameQueries {
    std::vector<Pending> scopes;  // grows to the largest frame, then stays
    std::size_t used = 0;
    std::uint64_t frame = 0;
  };
  std::size_t begin(const char* name);
  void end(std::size_t scope);
  void changeMode();
  void collect(FrameQueries& frame);

  Mode mode_;
  Mode nextMode_;
  bool debugGroups_;
  std::array<FrameQueries, kFramesInFlight> frames_;
  std::size_t frame_ = 0;  // of frames_
  std::uint64_t currentFrame_ = 0;
  std::vector<StageTime> stages_;
  std::uint64_t stagesFrame_ = 0;
  std::vector<StageTime> current_;  // finish mode
  std::vector<std::chrono::steady_clock::time_point> starts_;
};

class Scope {
 public:
  Scope(Profiler& profiler, const char* name);
  ~Scope();
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;

 private:
  Profiler& profiler_;
  std::size_t index_;
};

}  // namespace mres::gl
