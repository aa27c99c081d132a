# Writes a source that tells the version and, in a checkout, the commit: 0.1.0+7234c20, or
# 0.1.0+7234c20.changed where files differ from it. A script, run before each build; the source is
# left as it is while that says the same.
#   cmake -DVERSION=0.1.0 -DSOURCE=folder -DOUTPUT=file.cpp -P build_version.cmake
set(text "${VERSION}")
if(EXISTS "${SOURCE}/.git")
  execute_process(
    COMMAND git -C "${SOURCE}" describe --always --dirty=.changed --exclude=*
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(failed EQUAL 0)
    string(APPEND text "+${commit}")
  endif()
endif()
set(content "#include \"process/build_version.hpp\"\n
const char* surefoot::process::build_version() { return \"${text}\"; }\n")
set(before "")
if(EXISTS "${OUTPUT}")
  file(READ "${OUTPUT}" before)
endif()
if(NOT content STREQUAL before)
  file(WRITE "${OUTPUT}" "${content}")
endif()
