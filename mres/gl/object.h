// Move-only owners of OpenGL names. The host's own names stay plain GLuint and are never deleted here.
#pragma once

#include <epoxy/gl.h>
#include <utility>

namespace mres::gl {

/// Owns one OpenGL name; Traits::create makes it and Traits::destroy deletes it.
template <class Traits>
class Object {
 public:
  Object() = default;
  static Object create() { return Object(Traits::create()); }

  Object(Object&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;
  ~Object() {
    if (id_ != 0) Traits::destroy(id_);
  }

  [[nodiscard]] GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  explicit Object(GLuint id) : id_(id) {}
  GLuint id_ = 0;
};

// NOLINTBEGIN(bugprone-macro-parentheses): a name that is declared cannot stand in parentheses
#define MRES_GL_OBJECT(Name, Generate, Delete)         \
  struct Name##Traits {                                \
    static GLuint create() {                           \
      GLuint id = 0;                                   \
      Generate(1, &id);                                \
      return id;                                       \
    }                                                  \
    static void destroy(GLuint id) { Delete(1, &id); } \
  };                                                   \
  using Name = Object<Name##Traits>
// NOLINTEND(bugprone-macro-parentheses)

MRES_GL_OBJECT(TextureName, glGenTextures, glDeleteTextures);
MRES_GL_OBJECT(BufferName, glGenBuffers, glDeleteBuffers);
MRES_GL_OBJECT(FramebufferName, glGenFramebuffers, glDeleteFramebuffers);
MRES_GL_OBJECT(RenderbufferName, glGenRenderbuffers, glDeleteRenderbuffers);
MRES_GL_OBJECT(VertexArrayName, glGenVertexArrays, glDeleteVertexArrays);
MRES_GL_OBJECT(SamplerName, glGenSamplers, glDeleteSamplers);
MRES_GL_OBJECT(QueryName, glGenQueries, glDeleteQueries);
#undef MRES_GL_OBJECT

struct ProgramTraits {
  static GLuint create() { return glCreateProgram(); }
  static void destroy(GLuint id) { glDeleteProgram(id); }
};
using ProgramName = Object<ProgramTraits>;

}  // namespace mres::gl
