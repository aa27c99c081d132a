# Holds docs/config.md to the program: cmake -D program=... -D page=... -P check_config_page.cmake
execute_process(COMMAND ${program} config --markdown OUTPUT_VARIABLE printed RESULT_VARIABLE result)
file(READ ${page} written)
if(NOT result EQUAL 0 OR NOT printed STREQUAL written)
  message(FATAL_ERROR "${page} is not what `surefoot config --markdown` prints; write it anew")
endif()
