#include "host/renderer/embedded_shaders.h"

#include "mres/embedded_shaders.h"

namespace host {

mres::gl::ShaderLibrary shaderLibrary(const std::string& directory) {
  mres::gl::ShaderLibrary library;
  library.add(mres::embeddedShaders());
  library.add(embeddedShaders());
  library.setDirectory(directory);
  return library;
}

}  // namespace host
