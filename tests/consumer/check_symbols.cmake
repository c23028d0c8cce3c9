# Run with cmake -P. Fails if the shared library LIBRARY needs a vk symbol or a function of files, or
# if its exported symbols, of any kind, are not exactly the functions that the headers in INCLUDE
# declare.
execute_process(COMMAND ${NM} -D ${LIBRARY} OUTPUT_VARIABLE symbols RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "nm cannot read ${LIBRARY}")
endif()
string(REGEX MATCHALL "[^\n]* vk[A-Z][^\n]*" vulkan "${symbols}")
if(vulkan)
  message(FATAL_ERROR "Vulkan symbols in ${LIBRARY}: ${vulkan}")
endif()
string(REGEX MATCHALL
  "[^\n]* (_Z[A-Z]+St10filesystem|(f?open|read|write|rename|f?stat)(64)?@)[^\n]*" files "${symbols}")
if(files)
  message(FATAL_ERROR "${LIBRARY} uses files: ${files}")
endif()

set(declared "")
foreach(header lichen.h lichen_vulkan.h)
  file(READ ${INCLUDE}/${header} text)
  string(REGEX MATCHALL "LICHEN_API [A-Za-z0-9_]+ lichen[A-Za-z]+\\(" functions "${text}")
  list(TRANSFORM functions REPLACE "LICHEN_API [A-Za-z0-9_]+ (lichen[A-Za-z]+)\\(" "T \\1")
  list(APPEND declared ${functions})
endforeach()
# nm prints no address for undefined symbols. It lists constants, vtables and inline functions as D,
# R, V, W or u.
string(REGEX MATCHALL "[0-9a-f]+ [A-Za-z] [^\n]*" shown "${symbols}")
list(TRANSFORM shown REPLACE "^[0-9a-f]+ " "")
list(SORT declared)
list(SORT shown)
if(NOT declared)
  message(FATAL_ERROR "${INCLUDE} declares no function")
endif()
if(NOT shown STREQUAL declared)
  set(missing ${declared})
  set(added ${shown})
  list(REMOVE_ITEM missing ${shown})
  list(REMOVE_ITEM added ${declared})
  message(FATAL_ERROR "${LIBRARY}: declared and not shown: ${missing}; shown and not declared: "
                      "${added}")
endif()
