# mres_embed_shaders(TARGET FUNCTION FOLDER...)
# Embeds every shader file below shaders/FOLDER into TARGET, readable through
#   std::span<const mres::gl::ShaderFile> FUNCTION();   e.g. mres::embeddedShaders
# The files are named by their path below shaders/, which is what #include "..." in GLSL uses.
function(mres_embed_shaders target function)
  set(shader_root ${mres_SOURCE_DIR}/shaders)
  set(files)
  foreach(folder IN LISTS ARGN)
    file(GLOB_RECURSE found CONFIGURE_DEPENDS RELATIVE ${shader_root}
         ${shader_root}/${folder}/*.glsl ${shader_root}/${folder}/*.vert
         ${shader_root}/${folder}/*.frag ${shader_root}/${folder}/*.h)
    list(APPEND files ${found})
  endforeach()
  list(TRANSFORM files PREPEND ${shader_root}/ OUTPUT_VARIABLE paths)

  set(output ${CMAKE_CURRENT_BINARY_DIR}/${target}_shaders.cpp)
  set(script ${mres_SOURCE_DIR}/cmake/embed_shaders.cmake)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DFUNCTION=${function} -DROOT=${shader_root}
            "-DFILES=${files}" -P ${script}
    DEPENDS ${paths} ${script}
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()
