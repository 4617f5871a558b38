// What an engine hands over each frame. The textures stay the engine's: mres reads them through samplers of
// its own and changes nothing about them.
//
// Conventions, once for the whole library:
//  - View space is right-handed and looks along -Z; one unit is one metre (an effect's radius is in metres).
//  - Pixel (0, 0) is at the lower left, as OpenGL has it; pixel centres lie at + 0.5.
//  - `view depth` is the distance to the camera along -Z: positive in front of it.
//  - `window depth` is the value in the depth texture, 0..1. Whether it is reversed, whether the far plane is
//    infinite, and whether the camera is orthographic all follow from the projection matrix.
//  - A pixel whose window depth is that of the far plane is background and has no surface.
#pragma once

#include <cstdint>
#include <epoxy/gl.h>
#include <glm/glm.hpp>

namespace mres {

/// The clip-space depth range that the projection matrix maps to.
enum class ClipDepth {
  minusOneToOne,  ///< OpenGL's default
  zeroToOne       ///< glClipControl(..., GL_ZERO_TO_ONE)
};

enum class NormalSpace { view, world };

enum class NormalEncoding {
  signedXyz,   ///< texel.xyz is the normal (float or signed-normalised formats)
  unsignedXyz  ///< texel.xyz * 2 - 1 is the normal (unsigned-normalised formats)
};

struct Frame {
  GLuint depth = 0;  ///< GL_TEXTURE_2D, any depth format, comparison off, `size` texels
  /// GL_TEXTURE_2D, three or four channels, `size` texels; unit-length surface normals. Those before normal
  /// mapping keep the masks small.
  GLuint normals = 0;
  /// GL_TEXTURE_2D, red 0..1, any size, sampled bilinearly over the screen, e.g. foveation or motion;
  /// MaskSettings::combination joins it with the edges. 0: none.
  GLuint importance = 0;
  glm::ivec2 size{0};  ///< pixels, 1..16384 each
  /// A number of the host's for these depths, normals and this camera, a new one each frame: what is made of
  /// them alone, depth mips and edges, is then made once for all effects of a frame. 0: once for each.
  std::uint64_t id = 0;
  /// World to view; a rotation and translation. Unused if the normals are in view space.
  glm::mat4 view{1.0f};
  /// View to clip; perspective or orthographic, may be off-centre; no oblique near plane.
  glm::mat4 projection{1.0f};
  ClipDepth clipDepth = ClipDepth::minusOneToOne;
  NormalSpace normalSpace = NormalSpace::world;
  NormalEncoding normalEncoding = NormalEncoding::unsignedXyz;
};

}  // namespace mres
