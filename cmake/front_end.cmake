# lichen::front_end: of programs whose own files read a command line and call libraries. A compiler
# takes longer to optimize what the parser's headers bring along than for all else, and a parse is
# over at once either way. Not -O0: of an inline function that a program shares with its libraries
# the linker keeps one body, which may be the program's.
add_library(lichen_front_end INTERFACE)
add_library(lichen::front_end ALIAS lichen_front_end)
target_compile_options(lichen_front_end INTERFACE $<$<CONFIG:Release>:-O1>)
