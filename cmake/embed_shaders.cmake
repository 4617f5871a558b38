# Writes OUTPUT, a C++ file whose FUNCTION returns the text of FILES (paths below ROOT).
string(REGEX REPLACE "::[^:]*$" "" namespace "${FUNCTION}")
string(REGEX REPLACE "^.*::" "" name "${FUNCTION}")

set(entries)
foreach(file IN LISTS FILES)
  file(READ ${ROOT}/${file} text)
  # String literals are limited to 64 KiB by the standard's minimum; shaders stay far below.
  string(APPEND entries "    {\"${file}\", R\"glsl(${text})glsl\"},\n")
endforeach()

file(WRITE ${OUTPUT} "// Generated from shaders/ by cmake/embed_shaders.cmake.
#include <array>
#include <span>

#include \"mres/gl/shader_library.h\"

namespace ${namespace} {
std::span<const mres::gl::ShaderFile> ${name}();
std::span<const mres::gl::ShaderFile> ${name}() {
  static constexpr auto kFiles = std::to_array<mres::gl::ShaderFile>({
${entries}  });
  return kFiles;
}
}  // namespace ${namespace}
")
