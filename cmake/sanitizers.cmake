# LICHEN_SANITIZE=address,undefined instruments everything built here; a report ends the program.
if(LICHEN_SANITIZE)
  add_compile_options(-fsanitize=${LICHEN_SANITIZE} -fno-sanitize-recover=all
                      -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=${LICHEN_SANITIZE})
  # This one check keeps inner loops from being vectorized: without it a small bake takes two thirds
  # of the time. What an address that wraps round points at is no object, and reading or writing
  # there is what AddressSanitizer reports.
  if(LICHEN_SANITIZE MATCHES "undefined")
    add_compile_options(-fno-sanitize=pointer-overflow)
    # These two are half of the time of compiling Eigen's templates, and neither alone is less. What
    # reads or writes through null AddressSanitizer reports; what may be misaligned is bytes of a
    # file: lichen_check_pointers() where those are read.
    add_compile_options(-fno-sanitize=null,alignment)
  endif()
endif()
string(REPLACE "," ";" LICHEN_SANITIZERS "${LICHEN_SANITIZE}")

# lichen_check_pointers(TARGET): of a library that makes numbers of a file's bytes.
function(lichen_check_pointers target)
  if("undefined" IN_LIST LICHEN_SANITIZERS)
    target_compile_options(${target} PRIVATE -fsanitize=null,alignment)
  endif()
endfunction()

if("thread" IN_LIST LICHEN_SANITIZERS)
  # The resolver that picks a clone runs while the program is being loaded, before ThreadSanitizer
  # is: instrumented, it crashes there. Without clones there is no resolver.
  add_compile_options("-Dtarget_clones(...)=")
  include_directories(BEFORE ${PROJECT_SOURCE_DIR}/tests/tsan) # headers in front of oneTBB's
endif()
