#pragma once

#include "mres/gl/object.h"

namespace mres::gl {

/// True where GL_KHR_debug (core since 4.3) offers labels and debug groups.
inline bool hasDebugLabels() {
  return epoxy_gl_version() >= 43 || epoxy_has_gl_extension("GL_KHR_debug");
}

/// Names an object for frame debuggers.
inline void setLabel(GLenum identifier, GLuint name, const char* label) {
  if (hasDebugLabels()) glObjectLabel(identifier, name, -1, label);
}

}  // namespace mres::gl
