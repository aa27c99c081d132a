# What every target of the project shares: the language, the warnings, the include paths.
include(GNUInstallDirs)

function(surefoot_common target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           -Wno-sign-conversion)
endfunction()

# An internal static library of the program: surefoot_component(dataset a.cpp b.cpp).
function(surefoot_component name)
  add_library(surefoot_${name} STATIC ${ARGN})
  surefoot_common(surefoot_${name})
  target_include_directories(surefoot_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(surefoot_${name} PUBLIC surefoot)
endfunction()

# A GoogleTest program: surefoot_test(unit_geometry LIBS surefoot SOURCES a.cpp [LABELS long]).
function(surefoot_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBS;LABELS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  surefoot_common(${name})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE
    SUREFOOT_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    SUREFOOT_SHARED_DATA="${PROJECT_SOURCE_DIR}/../shared/data")
  target_link_libraries(${name} PRIVATE ${arg_LIBS} GTest::gtest_main)
  set_target_properties(${name} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}")
endfunction()
