#pragma once

#include <span>

#include "mres/gl/shader_library.h"

namespace host {

/// The files of shaders/host/, put into the program by the build.
std::span<const mres::gl::ShaderFile> embeddedShaders();

/// Those, and the files of mres that they include.
mres::gl::ShaderLibrary shaderLibrary();

}  // namespace host
