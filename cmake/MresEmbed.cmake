# mres_embed_files(TARGET FUNCTION TYPE HEADER ROOT FILE...)
# Embeds files, named by their path below ROOT, into TARGET, readable through
#   std::span<const TYPE> FUNCTION();
# where TYPE, an aggregate of name and text, is of HEADER.
function(mres_embed_files target function type header root)
  list(TRANSFORM ARGN PREPEND ${root}/ OUTPUT_VARIABLE paths)
  string(REGEX REPLACE "^.*::" "" name ${function})
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${target}_${name}.cpp)
  set(script ${mres_SOURCE_DIR}/cmake/embed_files.cmake)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DFUNCTION=${function} -DTYPE=${type} -DHEADER=${header}
            -DROOT=${root} "-DFILES=${ARGN}" -P ${script}
    DEPENDS ${paths} ${script}
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()

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
  mres_embed_files(${target} ${function} mres::gl::ShaderFile mres/gl/shader_library.h ${shader_root} ${files})
endfunction()
