#pragma once

#include <span>

#include "mres/gl/shader_library.h"

namespace mres {

/// The files of shaders/common/ and shaders/mres/, put into the program by the build.
std::span<const gl::ShaderFile> embeddedShaders();

}  // namespace mres
