# lichen::command_options: how all programs declare options, reject bad values and show progress. A
# library, because the parser's headers take longer to compile than the programs' own files. It does
# not use lichen::analysis, so programs without that library can link it.
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
set(folder ${PROJECT_SOURCE_DIR}/analysis/cli)
add_library(lichen_command_options STATIC EXCLUDE_FROM_ALL
  ${folder}/options.cpp ${folder}/progress_line.cpp)
add_library(lichen::command_options ALIAS lichen_command_options)
target_include_directories(lichen_command_options PUBLIC
  ${folder} ${PROJECT_SOURCE_DIR}/analysis/include)
target_link_libraries(lichen_command_options
  PUBLIC lichen::bundle_files lichen::front_end CLI11::CLI11 fmt::fmt PRIVATE lichen::warnings)
