# What every target of the project shares: the language, the warnings, the include paths.
include(GNUInstallDirs)

function(surefoot_common target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                                           -Wno-sign-conversion)
  # Undefined whatever it does, and no false alarm: stops a release build too.
  target_compile_options(${target} PRIVATE -Werror=return-type)
  if(SUREFOOT_HARDENED)
    surefoot_harden(${target})
  endif()
  if(SUREFOOT_SAME_BITS AND CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64|arm64|ARM64")
    # By the compiler, and by what Eigen looks at.
    target_compile_options(${target} PRIVATE -ffp-contract=off -U__ARM_FEATURE_FMA)
  endif()
endfunction()

# As dpkg-buildflags has it with hardening=+all; a position-independent program is the rule anyway.
if(SUREFOOT_HARDENED)
  include(CheckPIESupported)
  check_pie_supported(LANGUAGES CXX)
endif()
function(surefoot_harden target)
  target_compile_options(${target} PRIVATE -fstack-protector-strong -fstack-clash-protection
    -Wformat -Werror=format-security -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    target_compile_options(${target} PRIVATE -fcf-protection)
  endif()
  get_target_property(type ${target} TYPE)
  if(NOT type STREQUAL STATIC_LIBRARY)
    target_link_options(${target} PRIVATE -Wl,-z,relro,-z,now)
  endif()
endfunction()

# Headers that most sources parse again and again, parsed once. Sources still include what they use:
# the dev preset builds without.
if(SUREFOOT_PRECOMPILE)
  file(WRITE ${CMAKE_BINARY_DIR}/precompiled/empty.cpp "")
  add_library(surefoot_precompiled STATIC ${CMAKE_BINARY_DIR}/precompiled/empty.cpp)
  surefoot_common(surefoot_precompiled)
  find_package(Eigen3 3.4 REQUIRED NO_MODULE)
  target_link_libraries(surefoot_precompiled PRIVATE Eigen3::Eigen)
  set(SUREFOOT_PRECOMPILED <Eigen/Cholesky> <Eigen/Core> <Eigen/Eigenvalues> <Eigen/Geometry>
    <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <map> <memory> <optional> <set>
    <span> <sstream> <string> <string_view> <vector>)
  target_precompile_headers(surefoot_precompiled PRIVATE ${SUREFOOT_PRECOMPILED})
endif()
function(surefoot_precompile target)
  if(SUREFOOT_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM surefoot_precompiled)
  endif()
endfunction()

# Several sources of a component compiled as one: they parse the same headers, which is most of the
# time. The dev preset builds without, so that a source that leans on another one's includes is seen.
function(surefoot_unity target)
  if(SUREFOOT_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
endfunction()

# An internal static library of the program: surefoot_component(dataset a.cpp b.cpp).
function(surefoot_component name)
  add_library(surefoot_${name} STATIC ${ARGN})
  surefoot_common(surefoot_${name})
  target_include_directories(surefoot_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
  target_link_libraries(surefoot_${name} PUBLIC surefoot)
  surefoot_precompile(surefoot_${name})
endfunction()

# No test is of the compiler: what is tested is compiled as users have it, what tests it with less
# effort, which is a quarter of its time.
function(surefoot_test_options target)
  surefoot_common(${target})
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# A GoogleTest program: surefoot_test(unit_geometry LIBS surefoot SOURCES a.cpp [LABELS long]).
function(surefoot_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBS;LABELS" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  surefoot_test_options(${name})
  surefoot_unity(${name})
  if(SUREFOOT_UNITY)  # a local name hides another source's; the dev preset says what else is hidden
    target_compile_options(${name} PRIVATE -Wno-shadow)
  endif()
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE
    SUREFOOT_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    SUREFOOT_SHARED_DATA="${PROJECT_SOURCE_DIR}/../shared/data")
  target_link_libraries(${name} PRIVATE ${arg_LIBS} GTest::gtest_main)
  if(SUREFOOT_PRECOMPILE)
    if(NOT TARGET surefoot_test_precompiled)
      add_executable(surefoot_test_precompiled ${CMAKE_BINARY_DIR}/precompiled/empty.cpp)
      surefoot_test_options(surefoot_test_precompiled)
      target_link_libraries(surefoot_test_precompiled PRIVATE surefoot GTest::gtest_main)
      target_precompile_headers(surefoot_test_precompiled PRIVATE ${SUREFOOT_PRECOMPILED} <gtest/gtest.h>)
    endif()
    target_precompile_headers(${name} REUSE_FROM surefoot_test_precompiled)
  endif()
  set_target_properties(${name} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}")
endfunction()
