#pragma once

#include <string>
#include <string_view>

#include "mres/gl/object.h"
#include "mres/gl/shader_library.h"

namespace mres::gl {

/// A linked program of a vertex and a fragment shader.
class Program {
 public:
  struct Sources {
    std::string vertex;    ///< shader file name
    std::string fragment;  ///< shader file name
    std::string defines;   ///< lines such as "#define SAMPLES 4\n", put after #version
  };

  Program() = default;
  /// Throws std::runtime_error with the compiler's message mapped to file names and lines.
  Program(const ShaderLibrary& library, const Sources& sources);

  [[nodiscard]] GLuint id() const { return name_.id(); }
  /// Binds sampler uniform `name` to a texture unit; a name that the compiler removed is ignored.
  /// Needs the program in use.
  void setTextureUnit(const char* name, GLint unit) const;
  /// Binds uniform block `name` to a binding point; a block that the compiler removed is ignored.
  void setBlockBinding(const char* name, GLuint binding) const;
  [[nodiscard]] GLint uniformLocation(const char* name) const;
  explicit operator bool() const { return static_cast<bool>(name_); }

 private:
  ProgramName name_;
};

}  // namespace mres::gl
