# lichen::front_end: of programs whose own files read a command line and call libraries. A compiler
# takes longer to optimize what the parser's headers bring along than for all else, and a parse is
# over at once either way.
add_library(lichen_front_end INTERFACE)
add_library(lichen::front_end ALIAS lichen_front_end)
target_compile_options(lichen_front_end INTERFACE $<$<CONFIG:Release>:-O0>)
