# Run with cmake -P. Checks that lichen.glsl compiles in a host's vertex, fragment and compute
# shaders, in any descriptor set and from any first binding, and that it refuses a number of maps
# that no noise has.
function(compile stage defines)
  list(TRANSFORM defines PREPEND -D)
  execute_process(COMMAND ${GLSLANG} -V --target-env vulkan1.0 -S ${stage} -I${INCLUDE} ${defines}
                          -o ${WORK_DIR}/host_shader.spv ${SHADER}
                  RESULT_VARIABLE result OUTPUT_VARIABLE output)
  set(failed ${result} PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

foreach(stage vert frag comp)
  foreach(defines
      "LICHEN_SET=0;LICHEN_MAP_COUNT=1"
      "LICHEN_SET=3;LICHEN_FIRST_BINDING=7;LICHEN_MAP_COUNT=6")
    compile(${stage} "${defines}")
    if(failed)
      message(FATAL_ERROR "${stage} ${defines}: ${output}")
    endif()
  endforeach()
endforeach()

foreach(count "" LICHEN_MAP_COUNT=0 LICHEN_MAP_COUNT=7)
  compile(frag "LICHEN_SET=0;${count}")
  if(NOT failed OR NOT output MATCHES "#error.*number of maps")
    message(FATAL_ERROR "\"${count}\" is not refused: ${output}")
  endif()
endforeach()
