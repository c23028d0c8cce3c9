# LICHEN_SANITIZE=address,undefined instruments everything built here; a report ends the program.
if(LICHEN_SANITIZE)
  add_compile_options(-fsanitize=${LICHEN_SANITIZE} -fno-sanitize-recover=all
                      -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=${LICHEN_SANITIZE})
endif()
