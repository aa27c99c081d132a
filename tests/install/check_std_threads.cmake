# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
#
# The package of a library with the standard library's threads is found: it asks for these, and not
# for oneTBB. Nothing is compiled: an empty file stands for the library.
#
#   cmake -D sources=DIR -D consumer=DIR -D compiler=FILE -D folder=DIR -P check_std_threads.cmake
file(REMOVE_RECURSE ${folder})
function(run)
  execute_process(COMMAND ${CMAKE_COMMAND} ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "cmake ${ARGN}:\n${said}")
  endif()
endfunction()
run(-S ${sources} -B ${folder}/build -DCMAKE_CXX_COMPILER=${compiler} -DSUREFOOT_STD_THREADS=ON
    -DSUREFOOT_APP=OFF -DSUREFOOT_COMPONENTS=OFF -DSUREFOOT_C_LIBRARY=OFF -DSUREFOOT_TESTS=OFF
    -DSUREFOOT_BENCHMARKS=OFF -DCMAKE_INSTALL_LIBDIR=lib)
file(WRITE ${folder}/build/src/libsurefoot.a "")
run(--install ${folder}/build --prefix ${folder}/prefix --component dev)
run(-S ${consumer} -B ${folder}/consumer -DCMAKE_CXX_COMPILER=${compiler}
    -DCMAKE_PREFIX_PATH=${folder}/prefix -DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON)
file(READ ${folder}/prefix/lib/pkgconfig/surefoot.pc pc)
if(pc MATCHES "tbb" OR NOT pc MATCHES "-pthread")
  message(FATAL_ERROR "surefoot.pc: expected -pthread, and no tbb:\n${pc}")
endif()
