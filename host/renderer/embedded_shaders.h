#pragma once

#include <span>
#include <string>

#include "mres/gl/shader_library.h"

namespace host {

/// The files of shaders/host/, put into the program by the build.
std::span<const mres::gl::ShaderFile> embeddedShaders();

/// Those, and the files of mres that they include; files below `directory` win over them.
mres::gl::ShaderLibrary shaderLibrary(const std::string& directory = {});

}  // namespace host
