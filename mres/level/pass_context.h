#pragma once

#include "mres/effect.h"
#include "mres/gl/full_screen.h"
#include "mres/gl/profiler.h"
#include "mres/gl/program.h"
#include "mres/gl/shader_library.h"
#include "mres/gl/state_guard.h"
#include "mres/gl/texture.h"

namespace mres {

/// Texture units that mres's passes read from. An effect's own start at kEffectTextureUnit.
enum TextureUnit : GLuint {
  kDepthUnit = 0,
  kNormalUnit = 1,
  kSourceUnit = 2,
  kCoarserUnit = 3,
  kMaskUnit = 4,
  kZoneUnit = 5  ///< the zone, or the refinement that it is made of
};

static_assert(kZoneUnit < kEffectTextureUnit, "an effect's textures stay bound while levels are composed");

/// Uniform blocks; an effect's own start at kEffectBlockBinding.
enum BlockBinding : GLuint { kFrameBlock = 0, kLevelBlock = 1, kPassBlock = 2 };

static_assert(kPassBlock < kEffectBlockBinding, "an effect's blocks stay bound while levels are composed");
static_assert(kEffectTextureUnit + 6 == gl::kTextureUnits && kEffectBlockBinding + 2 == gl::kUniformBindings,
              "the state guard saves what is the effect's, too");

/// What all passes of one MultiResolution share.
struct PassContext {
  gl::ShaderLibrary library;
  gl::Profiler profiler;
  gl::FullScreenTriangle triangle;
  gl::SamplerName nearest = gl::makeSampler(gl::Filter::nearest);
  gl::SamplerName nearestMip = gl::makeSampler(gl::Filter::nearestMip);
  gl::SamplerName linear = gl::makeSampler(gl::Filter::linear);
};

/// A full-screen program of `fragment` with mres's samplers and blocks bound by name; left in use.
gl::Program makePassProgram(const gl::ShaderLibrary& library, const char* fragment,
                            const std::string& defines = {});

}  // namespace mres
