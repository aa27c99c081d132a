# Holds every source to .clang-format. Other versions than 14 format differently, so that one is
# needed; without it the test is skipped.
find_program(CLANG_FORMAT NAMES clang-format-14 clang-format)
if(CLANG_FORMAT)
  execute_process(COMMAND ${CLANG_FORMAT} --version OUTPUT_VARIABLE version)
endif()
if(NOT version MATCHES "version 14\\.")
  message("SKIPPED: no clang-format 14 here")
  return()
endif()
file(GLOB_RECURSE sources
  ${root}/include/*.hpp ${root}/src/*.[ch]pp ${root}/apps/*.[ch]pp
  ${root}/bindings/*.[ch]pp
  ${root}/benchmarks/*.[ch]pp ${root}/tests/*.[ch]pp)
execute_process(COMMAND ${CLANG_FORMAT} --dry-run -Werror ${sources} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "clang-format -i changes the files above")
endif()
