#pragma once

#include "host/measure/interleaved.h"
#include "mres/gl/object.h"

namespace host {

/// Times OpenGL work of the current context by glFinish and std::chrono::steady_clock, and by a
/// GL_TIME_ELAPSED query as well. That is the truth on a GPU; on a software rasteriser it ends before the
/// work is done (llvmpipe reported 0.2 ms for a draw of 150 ms).
class GlTimer {
 public:
  explicit GlTimer(bool softwareRasterizer);
  RunTime operator()(const Work& work) const;

 private:
  Clock trusted_;
  mres::gl::QueryName query_;
};

}  // namespace host
