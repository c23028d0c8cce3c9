# Run with cmake -P. Checks that lichen.glsl compiles in a host's vertex, fragment and compute
# shaders, in any descriptor set, from any first binding and for any roles, and with images that the
# host declares.
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
      "LICHEN_SET=0"
      "LICHEN_SET=0;LICHEN_ROLES=1"
      "LICHEN_SET=0;LICHEN_ROLES=32" # without a role that the shader evaluates
      "LICHEN_SET=3;LICHEN_FIRST_BINDING=7;LICHEN_ROLES=63"
      "OWN_ARRAYS"
      "OWN_ARRAYS;OWN_CELLS"
      "OWN_ARRAYS;OWN_CELLS;LICHEN_METHODS=17")
    compile(${stage} "${defines}")
    if(failed)
      message(FATAL_ERROR "${stage} ${defines}: ${output}")
    endif()
  endforeach()
endforeach()
