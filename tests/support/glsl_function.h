#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "mres/gl/program.h"
#include "mres/gl/shader_library.h"

namespace mres::test {

/// All shader files of mres and of the effects.
gl::ShaderLibrary shaderLibrary();

/// Runs a GLSL expression on the GPU, once for each input, and returns its values. `preamble` is GLSL before
/// main() (e.g. #include "mres/frame.glsl"), `expression` a vec4 of the vec4s a and b. `prepare` may set
/// uniforms and blocks of the program, which is in use.
std::vector<glm::vec4> evaluate(const std::string& preamble, const std::string& expression,
                                std::span<const glm::vec4> a, std::span<const glm::vec4> b = {},
                                const std::function<void(const gl::Program&)>& prepare = {});

}  // namespace mres::test
