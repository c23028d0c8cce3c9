# Writes a SPIR-V module to a C++ header as an array, as glslangValidator --vn does. Run with
# cmake -DSPIRV=... -DVARIABLE=... -DOUTPUT=... -P.
cmake_minimum_required(VERSION 3.25)
file(READ ${SPIRV} bytes HEX)
# Little-endian words.
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1," words ${bytes})
string(REGEX REPLACE "([^,]*,[^,]*,[^,]*,[^,]*,[^,]*,[^,]*,[^,]*,[^,]*,)" "\\1\n" words ${words})
file(WRITE ${OUTPUT} "#pragma once
#include <cstdint>
const uint32_t ${VARIABLE}[] = {
${words}
};
")
