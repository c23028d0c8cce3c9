# LICHEN_SANITIZE=address,undefined instruments all code of this build; a finding ends the program.
if(LICHEN_SANITIZE)
  add_compile_options(-fsanitize=${LICHEN_SANITIZE} -fno-sanitize-recover=all
                      -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=${LICHEN_SANITIZE})
  # pointer-overflow keeps inner loops from being vectorized: without it a small bake takes two
  # thirds of the time. A pointer that wrapped around points to no object, so AddressSanitizer
  # reports any access through it.
  if(LICHEN_SANITIZE MATCHES "undefined")
    add_compile_options(-fno-sanitize=pointer-overflow)
    # null and alignment together take half of the time to compile Eigen's templates; dropping only
    # one saves nothing. AddressSanitizer reports accesses through null. Only the bytes of a file
    # may be misaligned: the libraries that read them use lichen_check_pointers().
    add_compile_options(-fno-sanitize=null,alignment)
  endif()
endif()
string(REPLACE "," ";" LICHEN_SANITIZERS "${LICHEN_SANITIZE}")

# lichen_check_pointers(TARGET): restores the null and alignment checks, for libraries that convert
# the bytes of a file to numbers.
function(lichen_check_pointers target)
  if("undefined" IN_LIST LICHEN_SANITIZERS)
    target_compile_options(${target} PRIVATE -fsanitize=null,alignment)
  endif()
endfunction()

if("thread" IN_LIST LICHEN_SANITIZERS)
  # The resolver of target_clones runs while the program loads, before ThreadSanitizer starts; an
  # instrumented resolver crashes there. Without clones there is no resolver.
  add_compile_options("-Dtarget_clones(...)=")
  include_directories(BEFORE ${PROJECT_SOURCE_DIR}/tests/tsan) # these headers shadow oneTBB's
endif()
