# Compiles through ccache if it is installed. The settings are here and not in the user's
# environment, so that a second checkout in another folder reuses everything that this one compiled.
find_program(LICHEN_CCACHE ccache)
mark_as_advanced(LICHEN_CCACHE)
if(NOT LICHEN_CCACHE OR CMAKE_CXX_COMPILER_LAUNCHER)
  return()
endif()
set(launcher ${CMAKE_COMMAND} -E env
  CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} # paths become relative to the build folder,
  CCACHE_NOHASHDIR=1                   # which is not part of the hash
  CCACHE_COMPILERCHECK=content
  # ccache needs these for precompiled headers, whose file times differ between checkouts.
  CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
  ${LICHEN_CCACHE})
set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
