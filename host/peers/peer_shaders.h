#pragma once

#include <span>
#include <string>

#include "mres/effect.h"
#include "mres/gl/shader_library.h"

namespace host {

/// The files of shaders/peers/, put into the program by the build.
std::span<const mres::gl::ShaderFile> peerShaders();

/// "#define NAME value\n".
std::string define(const char* name, int value);

/// What shaders must know of an effect: EFFECT_CHANNELS and FILTERED.
std::string effectDefines(const mres::EffectDescription& effect);

}  // namespace host
