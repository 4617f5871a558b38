#pragma once

#include <span>

#include "mres/gl/shader_library.h"

namespace mres::effects {

/// The files of shaders/effects/, put into the program by the build.
std::span<const gl::ShaderFile> embeddedShaders();

}  // namespace mres::effects
