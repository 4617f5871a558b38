#include "host/measure/gl_timer.h"

#include <chrono>

namespace host {
namespace {

double elapsedMs(GLuint query) {
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
  return static_cast<double>(nanoseconds) * 1e-6;
}

}  // namespace

GlTimer::GlTimer(bool softwareRasterizer)
    : trusted_(softwareRasterizer ? Clock::wall : Clock::gpu), query_(mres::gl::QueryName::create()) {}

RunTime GlTimer::operator()(const Work& work) const {
  glFinish();
  const auto start = std::chrono::steady_clock::now();
  glBeginQuery(GL_TIME_ELAPSED, query_.id());
  work();
  glEndQuery(GL_TIME_ELAPSED);
  glFinish();
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
  return {wall.count(), elapsedMs(query_.id()), trusted_};
}

}  // namespace host
