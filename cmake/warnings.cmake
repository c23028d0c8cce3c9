# lichen::warnings: the warnings for our own code, all of them errors. Never link it PUBLIC.
add_library(lichen_warnings INTERFACE)
add_library(lichen::warnings ALIAS lichen_warnings)
if(NOT MSVC) # whose warnings have other names
  target_compile_options(lichen_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Werror -Wshadow -Wconversion -Wsign-conversion -Wformat=2 -Wundef
    $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor -Wold-style-cast -Wcast-qual -Woverloaded-virtual>
    # Clang's -Wextra re-enables the warning that lichen_volk disables, whose options come earlier.
    $<$<CXX_COMPILER_ID:Clang>:-Wno-missing-field-initializers>
    # GCC 12 reports false positives from inlined standard containers at -O2 and above.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread
                             -Wno-maybe-uninitialized -Wno-restrict>)
endif()
