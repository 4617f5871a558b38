#include "host/renderer/embedded_shaders.h"

namespace mres {
std::span<const gl::ShaderFile> embeddedShaders();
}  // namespace mres

namespace host {

mres::gl::ShaderLibrary shaderLibrary() {
  mres::gl::ShaderLibrary library;
  library.add(mres::embeddedShaders());
  library.add(embeddedShaders());
  return library;
}

}  // namespace host
