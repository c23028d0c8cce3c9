# Run with cmake -P. Reads the layout of the interface's structs from a probe's SPIR-V and writes
# OUTPUT, a C++ header of static_asserts on offsets, sizes and types. Parameters: SPIRV_CROSS,
# SPIRV, OUTPUT.
execute_process(COMMAND ${SPIRV_CROSS} ${SPIRV} --reflect
                OUTPUT_VARIABLE json RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "spirv-cross cannot reflect ${SPIRV}")
endif()

# Handles every struct of the interface in the module; std140 and std430 give one type each.
string(CONCAT text "// Written by check_interface_layout.cmake from the probe's SPIR-V.\n#pragma once\n"
           "#include <lichen_interface.h>\n#include <cstddef>\n#include <type_traits>\n")
set(structs 0)
string(JSON types GET "${json}" types)
string(JSON type_count LENGTH "${types}")
math(EXPR last_type "${type_count} - 1")

# Returns the C++ spelling of a reflected type, and its size in bytes.
function(describe type cpp size)
  if(type STREQUAL "float" OR type STREQUAL "int" OR type STREQUAL "uint")
    set(${cpp} "${type}" PARENT_SCOPE)
    set(${size} 4 PARENT_SCOPE)
  elseif(type MATCHES "^[iu]?vec4$")
    set(${cpp} "lichen::shader::${type}" PARENT_SCOPE)
    set(${size} 16 PARENT_SCOPE)
  else() # another struct of the interface
    string(JSON name GET "${types}" ${type} name)
    set(${cpp} "lichen::shader::${name}" PARENT_SCOPE)
    set(${size} "sizeof(lichen::shader::${name})" PARENT_SCOPE)
  endif()
endfunction()

foreach(i RANGE ${last_type})
  string(JSON id MEMBER "${types}" ${i})
  string(JSON name GET "${types}" ${id} name)
  if(NOT name MATCHES "^Lichen")
    continue()
  endif()
  math(EXPR structs "${structs} + 1")
  string(JSON members GET "${types}" ${id} members)
  string(JSON member_count LENGTH "${members}")
  math(EXPR last_member "${member_count} - 1")
  foreach(m RANGE ${last_member})
    string(JSON member GET "${members}" ${m} name)
    string(JSON type GET "${members}" ${m} type)
    string(JSON offset GET "${members}" ${m} offset)
    describe(${type} cpp size)
    string(REPLACE "uint" "std::uint32_t" cpp "${cpp}")
    string(JSON length ERROR_VARIABLE none GET "${members}" ${m} array 0)
    if(none MATCHES "NOTFOUND")
      string(JSON stride GET "${members}" ${m} array_stride)
      string(APPEND text "static_assert(${size} == ${stride});\n")
      set(cpp "${cpp}[${length}]")
      set(size "${length} * ${stride}")
    endif()
    string(APPEND text
      "static_assert(offsetof(lichen::shader::${name}, ${member}) == ${offset});\n"
      "static_assert(std::is_same_v<decltype(lichen::shader::${name}::${member}), ${cpp}>);\n")
  endforeach()
  # Members are contiguous, so the last one must end where the C++ struct ends.
  string(APPEND text "static_assert(sizeof(lichen::shader::${name}) == ${offset} + ${size});\n")
endforeach()
if(structs LESS 3)
  message(FATAL_ERROR "only ${structs} structs of the interface in ${SPIRV}")
endif()
file(WRITE ${OUTPUT} "${text}")
