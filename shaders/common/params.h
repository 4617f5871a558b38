// Makes one header compile as C++ and as GLSL: a UNIFORM_BLOCK is a struct there and a std140 block here.
// Members are float, int, vec2, ivec2, vec4 and mat4 at their std140 offsets (no vec3: its padding differs);
// arrays only of vec4 and mat4.
#pragma once
#ifdef __cplusplus
#include <glm/glm.hpp>

// No line continuations here: GLSL has them from version 4.20 on only.
namespace mres::params {
using glm::ivec2;
using glm::mat4;
using glm::vec2;
using glm::vec4;
}  // namespace mres::params

#define UNIFORM_BLOCK(Name) struct alignas(16) Name
#define BEGIN_PARAMS namespace mres::params {
#define END_PARAMS }
#else
#define UNIFORM_BLOCK(Name) layout(std140) uniform Name
#define BEGIN_PARAMS
#define END_PARAMS
#endif
