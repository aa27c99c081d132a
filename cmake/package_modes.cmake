# Before and after cpack makes Debian packages: modes are those that Debian's own tools give, whatever the
# umask of who packs.
if(NOT DEFINED CPACK_PACKAGE_FILES)  # what is to be packed lies there
  file(GLOB_RECURSE paths LIST_DIRECTORIES true ${CPACK_TEMPORARY_DIRECTORY}/*)
  foreach(path ${paths})
    if(IS_DIRECTORY ${path} AND NOT IS_SYMLINK ${path})
      file(CHMOD ${path} PERMISSIONS ${CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS})
    endif()
  endforeach()
  return()
endif()
# A package is an archive of ar: 8 bytes, then before each part a header of 60, of text, with the part's mode at
# 40 and its size at 48.
foreach(package ${CPACK_PACKAGE_FILES})
  if(NOT package MATCHES "\\.deb$")
    continue()
  endif()
  file(SIZE ${package} end)
  set(at 8)
  while(at LESS end)
    math(EXPR mode_at "${at} + 40")
    execute_process(COMMAND printf "100644  "
      COMMAND dd of=${package} bs=1 seek=${mode_at} conv=notrunc status=none
      RESULTS_VARIABLE failed)
    if(NOT failed STREQUAL "0;0")
      message(FATAL_ERROR "${package}: its parts' modes cannot be set: ${failed}")
    endif()
    file(READ ${package} header OFFSET ${at} LIMIT 60)
    string(SUBSTRING "${header}" 48 10 size)
    string(STRIP "${size}" size)
    math(EXPR at "${at} + 60 + ${size} + ${size} % 2")
  endwhile()
endforeach()
