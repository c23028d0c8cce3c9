# Included by the scripts that write and check spirv/. Parameters: GLSLANG, FLAGS and SOURCES
# (separated by spaces; SOURCES relative to SOURCE_DIR), SOURCE_DIR (shaders_glsl/), SPIRV_DIR
# (spirv/) and WORK_DIR.
set(flags "${FLAGS}")
separate_arguments(FLAGS)
separate_arguments(SOURCES)

# Compiles SOURCE (relative to SOURCE_DIR) to OUTPUT. Sets HASH to a hash of all files that it read.
function(lichen_compile_spirv source output hash)
  execute_process(
    COMMAND ${GLSLANG} --quiet ${FLAGS} --depfile ${output}.d -o ${output} ${source}
    WORKING_DIRECTORY ${SOURCE_DIR} RESULT_VARIABLE failed OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(failed)
    message(FATAL_ERROR "${source} does not compile:\n${text}")
  endif()
  file(READ ${output}.d depends)
  string(REGEX REPLACE "^[^:]*: *" "" depends "${depends}")
  string(STRIP "${depends}" depends)
  string(REGEX REPLACE "[ \n]+" ";" depends "${depends}")
  set(files)
  foreach(file IN LISTS depends)
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${SOURCE_DIR} NORMALIZE)
    list(APPEND files ${file})
  endforeach()
  list(REMOVE_DUPLICATES files)
  list(SORT files)
  set(hashes)
  foreach(file IN LISTS files)
    file(SHA256 ${file} one)
    string(APPEND hashes ${one})
  endforeach()
  string(SHA256 all "${hashes}")
  set(${hash} ${all} PARENT_SCOPE)
endfunction()

# Returns the first line of the compiler's version text.
function(lichen_glslang_version version)
  execute_process(COMMAND ${GLSLANG} --version OUTPUT_VARIABLE text)
  string(REGEX MATCH "Glslang Version: [^\n]*" line "${text}")
  set(${version} "${line}" PARENT_SCOPE)
endfunction()
