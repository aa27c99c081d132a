# What a program in C does with an installed tree: pkg-config finds it, it compiles, and runs.
# cmake -D prefix=... -D libdir=... -D compiler=... -D source=... -D folder=... -P check_pkg_config.cmake
find_program(pkg_config pkg-config REQUIRED)
set(ENV{PKG_CONFIG_PATH} ${prefix}/${libdir}/pkgconfig)
foreach(name surefoot surefoot_c)
  execute_process(COMMAND ${pkg_config} --cflags --libs ${name} OUTPUT_VARIABLE flags
    RESULT_VARIABLE failed ERROR_VARIABLE said)
  if(failed OR NOT flags MATCHES "-l${name}")
    message(FATAL_ERROR "pkg-config --cflags --libs ${name}: ${flags}${said}")
  endif()
endforeach()
separate_arguments(flags UNIX_COMMAND "${flags}")
file(MAKE_DIRECTORY ${folder})
execute_process(COMMAND ${compiler} -std=c99 ${source} -o ${folder}/consumer ${flags} -lm
  RESULT_VARIABLE failed ERROR_VARIABLE said)
if(failed)
  message(FATAL_ERROR "does not compile with ${flags}:\n${said}")
endif()
set(ENV{LD_LIBRARY_PATH} ${prefix}/${libdir})
execute_process(COMMAND ${folder}/consumer RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "the program does not run: ${failed}")
endif()
