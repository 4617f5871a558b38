#include "mres/gl/profiler.h"

#include "mres/gl/label.h"

namespace mres::gl {
namespace {

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

bool isAvailable(const QueryName& query) {
  GLuint available = GL_FALSE;
  glGetQueryObjectuiv(query.id(), GL_QUERY_RESULT_AVAILABLE, &available);
  return available == GL_TRUE;
}

GLuint64 timestamp(const QueryName& query) {
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(query.id(), GL_QUERY_RESULT, &nanoseconds);
  return nanoseconds;
}

}  // namespace

Profiler::Profiler(Mode mode) : mode_(mode), nextMode_(mode), debugGroups_(hasDebugLabels()) {}

void Profiler::beginFrame(std::uint64_t frame) {
  if (mode_ != nextMode_) changeMode();
  currentFrame_ = frame;
  if (mode_ == Mode::finish) {
    current_.clear();
    starts_.clear();
  } else if (mode_ == Mode::query) {
    frame_ = (frame_ + 1) % kFramesInFlight;
    collect(frames_.at(frame_));
    frames_.at(frame_).used = 0;
    frames_.at(frame_).frame = frame;
  }
}

// Times and queries of the mode before would pass for those of the new one.
void Profiler::changeMode() {
  mode_ = nextMode_;
  stages_.clear();
  for (FrameQueries& frame : frames_) frame.used = 0;
}

void Profiler::endFrame() {
  if (mode_ != Mode::finish) return;
  stages_ = current_;
  stagesFrame_ = currentFrame_;
}

void Profiler::collect(FrameQueries& frame) {
  for (std::size_t i = 0; i < frame.used; ++i) {
    if (!isAvailable(frame.scopes[i].end)) return;  // never wait: that frame's times are dropped
  }
  if (frame.used == 0) return;
  stages_.clear();
  stagesFrame_ = frame.frame;
  for (std::size_t i = 0; i < frame.used; ++i) {
    const Pending& scope = frame.scopes[i];
    const GLuint64 nanoseconds = timestamp(scope.end) - timestamp(scope.begin);
    stages_.push_back({scope.name, static_cast<double>(nanoseconds) * 1e-6});
  }
}

std::size_t Profiler::begin(const char* name) {
  if (debugGroups_) glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
  if (mode_ == Mode::query) {
    FrameQueries& frame = frames_.at(frame_);
    if (frame.used == frame.scopes.size())
      frame.scopes.push_back({name, QueryName::create(), QueryName::create()});
    Pending& scope = frame.scopes[frame.used];
    scope.name = name;
    glQueryCounter(scope.begin.id(), GL_TIMESTAMP);
    return frame.used++;
  }
  if (mode_ == Mode::finish) {
    glFinish();
    current_.push_back({name, 0.0});
    starts_.push_back(std::chrono::steady_clock::now());
    return current_.size() - 1;
  }
  return 0;
}

void Profiler::end(std::size_t scope) {
  if (mode_ == Mode::query) {
    glQueryCounter(frames_.at(frame_).scopes[scope].end.id(), GL_TIMESTAMP);
  } else if (mode_ == Mode::finish) {
    glFinish();
    current_[scope].milliseconds = millisecondsSince(starts_[scope]);
  }
  if (debugGroups_) glPopDebugGroup();
}

Scope::Scope(Profiler& profiler, const char* name) : profiler_(profiler), index_(profiler.begin(name)) {}

Scope::~Scope() {
  profiler_.end(index_);
}

}  // namespace mres::gl
