# lichen::front_end: compile options for programs whose own files only read a command line and call
# libraries. At -O3 the compiler spends most of its time on the parser's headers, and a parse is
# fast either way. -O0 would not do: the linker keeps one body of each inline function that a
# program shares with its libraries, and that may be the program's.
add_library(lichen_front_end INTERFACE)
add_library(lichen::front_end ALIAS lichen_front_end)
target_compile_options(lichen_front_end INTERFACE $<$<CONFIG:Release>:-O1>)
