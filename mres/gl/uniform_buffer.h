#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <optional>

#include "mres/gl/object.h"

namespace mres::gl {

/// A uniform block of type Params (one of the shared *_params.h structs) in a buffer of its own.
template <class Params>
class UniformBuffer {
  static_assert(sizeof(Params) % 16 == 0, "std140 blocks are multiples of 16 bytes");

 public:
  /// Leaves the binding as it is: effects make theirs in the host's code, outside of any guard.
  UniformBuffer() : name_(BufferName::create()) {
    GLint bound = 0;
    glGetIntegerv(GL_UNIFORM_BUFFER_BINDING, &bound);
    glBindBuffer(GL_UNIFORM_BUFFER, name_.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof(Params), nullptr, GL_DYNAMIC_DRAW);
    glBindBuffer(GL_UNIFORM_BUFFER, static_cast<GLuint>(bound));
  }

  /// The same again costs nothing: the driver need not keep a copy for frames in flight.
  void upload(const Params& params) {
    const auto bytes = std::bit_cast<Bytes>(params);
    if (uploaded_ == bytes) return;
    uploaded_ = bytes;
    glBindBuffer(GL_UNIFORM_BUFFER, name_.id());
    glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof(Params), &params);
  }

  void bind(GLuint binding) const { glBindBufferBase(GL_UNIFORM_BUFFER, binding, name_.id()); }

 private:
  using Bytes = std::array<std::byte, sizeof(Params)>;

  BufferName name_;
  std::optional<Bytes> uploaded_;
};

}  // namespace mres::gl
