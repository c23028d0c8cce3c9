# Compiles through ccache where it is installed. Its settings are given here, not in a person's
# environment: with them a second checkout in another folder finds everything that this one compiled.
find_program(LICHEN_CCACHE ccache)
mark_as_advanced(LICHEN_CCACHE)
if(NOT LICHEN_CCACHE OR CMAKE_CXX_COMPILER_LAUNCHER)
  return()
endif()
set(launcher ${CMAKE_COMMAND} -E env
  CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} # paths of the checkout count relative to the build folder,
  CCACHE_NOHASHDIR=1                   # which does not count itself
  CCACHE_COMPILERCHECK=content
  # What ccache asks for with precompiled headers, whose times differ from checkout to checkout.
  CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
  ${LICHEN_CCACHE})
set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
