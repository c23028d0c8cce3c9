# GLSL -> SPIR-V, with the same flags for the committed files in spirv/ and for shaders that are
# compiled into a program.
find_program(LICHEN_GLSLANG glslangValidator)
mark_as_advanced(LICHEN_GLSLANG)

# Without spirv-opt: it can change an image, and the tests pin the SPIR-V. Only shaders whose time is
# measured are optimized.
find_program(LICHEN_SPIRV_OPT spirv-opt)
mark_as_advanced(LICHEN_SPIRV_OPT)
set(LICHEN_GLSLANG_FLAGS -V --target-env vulkan1.0)

# lichen_embed_shaders(TARGET SOURCES a.vert b.frag ... [DEFINES NAME=VALUE ...] [VARIANT v]
#                      [OPTIMIZE]):
# creates an interface library with one header per source: a.vert.h, which holds `const uint32_t
# a_vert[]`. The include path is shaders_glsl/. A change in any included file recompiles the shader.
# With VARIANT v the header is a.vert.v.h and the array a_vert_v, so that one program can hold
# several variants of a shader. With OPTIMIZE, spirv-opt -O optimizes the SPIR-V.
function(lichen_embed_shaders target)
  if(NOT LICHEN_GLSLANG)
    message(FATAL_ERROR "glslangValidator is needed for ${target}: install glslang-tools")
  endif()
  cmake_parse_arguments(arg "OPTIMIZE" "VARIANT" "SOURCES;DEFINES" ${ARGN})
  if(arg_OPTIMIZE AND NOT LICHEN_SPIRV_OPT)
    message(FATAL_ERROR "spirv-opt is needed for ${target}: install spirv-tools")
  endif()
  list(TRANSFORM arg_DEFINES PREPEND -D)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target})
  file(MAKE_DIRECTORY ${folder})
  set(headers)
  set(variables)
  foreach(source IN LISTS arg_SOURCES)
    cmake_path(ABSOLUTE_PATH source)
    cmake_path(GET source FILENAME name)
    if(arg_VARIANT)
      string(APPEND name .${arg_VARIANT})
    endif()
    string(REPLACE "." "_" variable ${name})
    set(header ${folder}/${name}.h)
    set(compile ${LICHEN_GLSLANG} --quiet ${LICHEN_GLSLANG_FLAGS} -I${PROJECT_SOURCE_DIR}/shaders_glsl
      ${arg_DEFINES})
    if(arg_OPTIMIZE)
      set(spirv ${folder}/${name}.spv)
      set(optimized ${folder}/${name}.optimized.spv)
      add_custom_command(
        OUTPUT ${spirv}
        COMMAND ${compile} --depfile ${spirv}.d -o ${spirv} ${source}
        DEPENDS ${source}
        DEPFILE ${spirv}.d
        COMMENT "Compiling shader ${name}"
        VERBATIM)
      add_custom_command(
        OUTPUT ${header}
        COMMAND ${LICHEN_SPIRV_OPT} -O ${spirv} -o ${optimized}
        COMMAND ${CMAKE_COMMAND} -DSPIRV=${optimized} -DVARIABLE=${variable} -DOUTPUT=${header}
                -P ${PROJECT_SOURCE_DIR}/cmake/embed_spirv.cmake
        DEPENDS ${spirv} ${PROJECT_SOURCE_DIR}/cmake/embed_spirv.cmake
        COMMENT "Optimizing shader ${name}"
        VERBATIM)
    else()
      add_custom_command(
        OUTPUT ${header}
        COMMAND ${compile} --vn ${variable} --depfile ${header}.d -o ${header} ${source}
        DEPENDS ${source}
        DEPFILE ${header}.d
        COMMENT "Compiling shader ${name}"
        VERBATIM)
    endif()
    list(APPEND headers ${header})
    list(APPEND variables ${variable})
  endforeach()
  add_custom_target(${target}_headers DEPENDS ${headers})
  add_library(${target} INTERFACE)
  add_dependencies(${target} ${target}_headers)
  target_include_directories(${target} SYSTEM INTERFACE ${folder})
  # For tests of all shaders: the headers in that folder, and the array in each.
  set_target_properties(${target} PROPERTIES
    LICHEN_SHADER_HEADERS "${headers}" LICHEN_SHADER_ARRAYS "${variables}")
endfunction()
