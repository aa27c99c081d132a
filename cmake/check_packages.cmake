# Makes the packages twice and looks into them:
# cmake -D build=... -D folder=... -D cpack=... -D expected="a;b" -D libdir=... -D hardened=...
#   -P check_packages.cmake
# The same bytes twice, whatever the umask, every package with its licence and changelog, lintian content if it is there:
# without errors and warnings but those that packaging/lintian gives a reason for; where they are built so,
# hardened programs and libraries.
find_program(dpkg_deb dpkg-deb)
if(NOT dpkg_deb)
  message("SKIPPED: no dpkg-deb here")
  return()
endif()
file(REMOVE_RECURSE ${folder})
set(ENV{SOURCE_DATE_EPOCH} 1700000000)
set(umask_1 022)
set(umask_2 077)
foreach(turn 1 2)
  execute_process(COMMAND sh -c "umask ${umask_${turn}} && exec \"$@\"" sh
      ${cpack} -G DEB -B ${folder}/${turn} --config ${build}/CPackConfig.cmake
    WORKING_DIRECTORY ${build} RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(failed)
    message(FATAL_ERROR "cpack failed:\n${said}")
  endif()
endforeach()

file(GLOB packages RELATIVE ${folder}/1 ${folder}/1/*.deb)
set(names)
foreach(package ${packages})
  file(SHA256 ${folder}/1/${package} first)
  file(SHA256 ${folder}/2/${package} second)
  if(NOT first STREQUAL second)
    message(SEND_ERROR "${package}: two builds differ")
  endif()
  string(REGEX REPLACE "_.*" "" name ${package})
  list(APPEND names ${name})
  execute_process(COMMAND ${dpkg_deb} --contents ${folder}/1/${package} OUTPUT_VARIABLE content)
  foreach(wanted copyright notices.txt changelog surefoot.spdx.json)
    if(NOT content MATCHES "/usr/share/doc/${name}/${wanted}")
      message(SEND_ERROR "${package} has no ${wanted}:\n${content}")
    endif()
  endforeach()
endforeach()
# What comes with the program and the module.
function(expect_content name)
  file(GLOB package ${folder}/1/${name}_*.deb)
  if(package)
    execute_process(COMMAND ${dpkg_deb} --contents ${package} OUTPUT_VARIABLE content)
    foreach(wanted ${ARGN})
      if(NOT content MATCHES "${wanted}")
        message(SEND_ERROR "${name} has no ${wanted}:\n${content}")
      endif()
    endforeach()
  endif()
endfunction()
expect_content(surefoot /usr/bin/surefoot /usr/lib/systemd/system/surefoot-live.service
  /usr/share/doc/surefoot/examples/live.env /usr/share/man/man1/surefoot-live.1.gz
  /usr/share/bash-completion/completions/surefoot /usr/share/bash-completion/completions/surefoot_fleet
  /usr/bin/surefoot_fleet /usr/share/surefoot/fleet/Snakefile /usr/share/surefoot/fleet/work.py
  /usr/share/surefoot/fleet/slurm/config.yaml)
expect_content(python3-surefoot /surefoot/evalio_datasets.py /surefoot/_core.pyi
  /usr/share/doc/python3-surefoot/examples/odometry.py)
list(SORT names)
list(SORT expected)
if(NOT "${names}" STREQUAL "${expected}")
  message(FATAL_ERROR "packages: ${names}\nexpected: ${expected}")
endif()

# What runs of them, as it is installed.
foreach(package ${packages})
  execute_process(COMMAND ${dpkg_deb} --extract ${folder}/1/${package} ${folder}/installed)
endforeach()
file(GLOB_RECURSE running ${folder}/installed/usr/bin/surefoot ${folder}/installed/*.so ${folder}/installed/*.so.*)
find_program(readelf readelf)
set(checked 0)
foreach(file ${running})
  if(IS_SYMLINK ${file} OR NOT hardened OR NOT readelf)
    continue()
  endif()
  math(EXPR checked "${checked} + 1")
  execute_process(COMMAND ${CMAKE_COMMAND} -D file=${file} -D readelf=${readelf}
    -P ${CMAKE_CURRENT_LIST_DIR}/../tests/install/check_hardening.cmake
    RESULT_VARIABLE failed ERROR_VARIABLE said)
  if(failed)
    message(SEND_ERROR "${said}")
  endif()
endforeach()
message("${checked} hardened programs and libraries")

# What they are made of: JSON, each part with its version and licence.
file(GLOB library ${folder}/1/libsurefoot-dev_*.deb)
execute_process(COMMAND ${dpkg_deb} --extract ${library} ${folder}/content)
file(READ ${folder}/content/usr/share/doc/libsurefoot-dev/surefoot.spdx.json sbom)
string(JSON parts LENGTH "${sbom}" packages)
math(EXPR last "${parts} - 1")
set(found)
foreach(i RANGE ${last})
  string(JSON name GET "${sbom}" packages ${i} name)
  string(JSON part_version GET "${sbom}" packages ${i} versionInfo)
  string(JSON licence GET "${sbom}" packages ${i} licenseDeclared)
  list(APPEND found ${name})
  if(part_version STREQUAL "" OR licence STREQUAL "")
    message(SEND_ERROR "surefoot.spdx.json: ${name}: version '${part_version}', licence '${licence}'")
  endif()
endforeach()
message("made of ${found}")
foreach(wanted surefoot libeigen3-dev)
  list(FIND found ${wanted} at)
  if(at EQUAL -1)
    message(SEND_ERROR "surefoot.spdx.json does not name ${wanted}")
  endif()
endforeach()

find_program(lintian lintian)
if(lintian)
  set(but)
  if(libdir STREQUAL lib)  # not as the preset package has it: the folder of one architecture
    set(but --suppress-tags pkg-config-unavailable-for-cross-compilation)
  endif()
  execute_process(COMMAND ${lintian} --allow-root --fail-on error,warning ${but} ${packages}
    WORKING_DIRECTORY ${folder}/1 RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
  message("${said}")
  if(failed)
    message(FATAL_ERROR "lintian finds errors or warnings")
  endif()
endif()
