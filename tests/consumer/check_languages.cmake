# Run with cmake -P. Checks that the shader library compiles as GLSL ES 3.00, and through
# SPIRV-Cross as HLSL of shader model 6, which glslang reads again, and as MSL.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output
                  ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}: ${output}")
  endif()
endfunction()

foreach(defines "" -DLICHEN_METHODS=1 -DLICHEN_METHODS=2 -DLICHEN_METHODS=4 -DLICHEN_METHODS=8
        "-DOWN_CELLS;-DLICHEN_METHODS=16" -DOWN_CELLS
        -DLICHEN_ANISOTROPIC=1 -DLICHEN_FEATURES=0x8FFFu)
  run(${GLSLANG} -l -S frag -I${INCLUDE} ${defines} ${ES_SHADER})
endforeach()

set(spirv ${WORK_DIR}/host_language.spv)
run(${GLSLANG} -V --target-env vulkan1.0 -S frag -I${INCLUDE} -DLICHEN_SET=0 -o ${spirv} ${SHADER})
set(modules ${spirv} ${PASSES})
foreach(module ${modules})
  get_filename_component(name ${module} NAME_WLE)
  set(stage comp)
  if(module STREQUAL "${spirv}")
    set(stage frag)
  endif()
  set(hlsl ${WORK_DIR}/${name}.hlsl)
  run(${SPIRV_CROSS} ${module} --hlsl --shader-model 60 --output ${hlsl})
  # Unoptimized, because glslang takes half a minute to optimize some HLSL.
  run(${GLSLANG} -D -V -Od -S ${stage} -e main -o ${WORK_DIR}/${name}.hlsl.spv ${hlsl})
  run(${SPIRV_CROSS} ${module} --msl --msl-version 20200 --output ${WORK_DIR}/${name}.metal)
endforeach()
