#include "mres/level/pass_context.h"

namespace mres {

gl::Program makePassProgram(const gl::ShaderLibrary& library, const char* fragment,
                            const std::string& defines) {
  gl::Program program(library, {"common/full_screen.vert", fragment, defines});
  glUseProgram(program.id());
  program.setTextureUnit("depthTexture", kDepthUnit);
  program.setTextureUnit("normalTexture", kNormalUnit);
  program.setTextureUnit("sourceTexture", kSourceUnit);
  program.setTextureUnit("levelTexture", kSourceUnit);
  program.setTextureUnit("zoneTexture", kZoneUnit);
  program.setTextureUnit("depthPyramid", kSourceUnit);
  program.setTextureUnit("coarserTexture", kCoarserUnit);
  program.setTextureUnit("maskTexture", kMaskUnit);
  program.setTextureUnit("finerMaskTexture", kMaskUnit);
  program.setTextureUnit("refineTexture", kZoneUnit);
  program.setBlockBinding("FrameParams", kFrameBlock);
  program.setBlockBinding("LevelParams", kLevelBlock);
  program.setBlockBinding("EdgesParams", kPassBlock);
  program.setBlockBinding("MaskBlurParams", kPassBlock);
  return program;
}

}  // namespace mres
