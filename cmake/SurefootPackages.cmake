# Debian packages by CPack, one a component: cmake --build build/release --target packages, or cpack
# in the build folder. Included last: everything that is installed names its component.
#
# surefoot          the program, its manual pages and completion
# libsurefoot-dev   library, headers, what find_package and pkg-config find
# libsurefoot-c0    the library behind plain C
# python3-surefoot  the Python module
set(doc ${CMAKE_INSTALL_DATADIR}/doc)

# Pages are made by the program itself, which has to run on this machine, be it under an emulator.
if(SUREFOOT_APP AND (NOT CMAKE_CROSSCOMPILING OR CMAKE_CROSSCOMPILING_EMULATOR))
  set(manual ${PROJECT_BINARY_DIR}/manual)
  add_custom_command(OUTPUT ${manual}/surefoot.1.gz
    COMMAND ${CMAKE_COMMAND} "-D program=${CMAKE_CROSSCOMPILING_EMULATOR};$<TARGET_FILE:surefoot_app>" -D folder=${manual}
            -P ${CMAKE_CURRENT_LIST_DIR}/write_manual.cmake
    DEPENDS surefoot_app ${CMAKE_CURRENT_LIST_DIR}/write_manual.cmake VERBATIM)
  add_custom_target(surefoot_manual ALL DEPENDS ${manual}/surefoot.1.gz)
  install(DIRECTORY ${manual}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools
    FILES_MATCHING PATTERN "*.1.gz")
  install(FILES ${manual}/surefoot.bash RENAME surefoot COMPONENT tools
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
endif()
# Of a live run as a service, which nothing starts by itself; and examples of Python.
if(SUREFOOT_APP)
  install(FILES ${PROJECT_SOURCE_DIR}/packaging/surefoot-live.service DESTINATION lib/systemd/system COMPONENT tools)
  install(FILES ${PROJECT_SOURCE_DIR}/packaging/live.env DESTINATION ${doc}/surefoot/examples COMPONENT tools)
endif()
if(TARGET surefoot_python)
  file(GLOB examples CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/python/*.py)
  install(FILES ${examples} DESTINATION ${doc}/python3-surefoot/examples COMPONENT python)
endif()

set(CPACK_COMPONENTS_ALL dev)
if(SUREFOOT_APP)
  list(APPEND CPACK_COMPONENTS_ALL tools)
endif()
if(TARGET surefoot_c)
  list(APPEND CPACK_COMPONENTS_ALL c)
endif()
if(TARGET surefoot_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_NAME surefoot)
set(CPACK_PACKAGE_VENDOR "The Surefoot authors")
set(CPACK_PACKAGE_CONTACT "The Surefoot authors <maintainers@users.noreply.h-seed-b0557e9f.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(CMAKE_CROSSCOMPILING)  # it looks at this machine's: packaging/cross_arm64 says what is needed
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS OFF)
  string(REPLACE aarch64 arm64 CPACK_DEBIAN_PACKAGE_ARCHITECTURE ${CMAKE_SYSTEM_PROCESSOR})
endif()
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

include(SurefootSbom)
include(SurefootNotices)

function(surefoot_package component name section description)
  string(TOUPPER ${component} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_COMPONENT_${key}_DESCRIPTION "LiDAR odometry for robots that walk: ${description}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_DEPENDS "${ARGN}" PARENT_SCOPE)
  # What every package of Debian's has: its licence, and what changed. And what it is made of.
  install(FILES ${PROJECT_BINARY_DIR}/package/surefoot.spdx.json DESTINATION ${doc}/${name}
    COMPONENT ${component})
  install(FILES ${PROJECT_BINARY_DIR}/package/copyright ${PROJECT_BINARY_DIR}/package/notices.txt
    DESTINATION ${doc}/${name} COMPONENT ${component})
  install(FILES ${PROJECT_BINARY_DIR}/package/changelog.gz DESTINATION ${doc}/${name}
    COMPONENT ${component})
  # What lintian says of it and is left as it is, with the reason.
  set(overrides ${PROJECT_SOURCE_DIR}/packaging/lintian/${name})
  if(EXISTS ${overrides})
    install(FILES ${overrides} DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT ${component})
  endif()
endfunction()
set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS snakemake)  # of surefoot_fleet
surefoot_package(tools surefoot science "the program\n Recordings or a sensor's packets in, trajectory and map out.")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS libceres-dev)  # of its component mapping
set(development libeigen3-dev)
if(SUREFOOT_TBB)
  set(development "libeigen3-dev, libtbb-dev")
endif()
if(TARGET surefoot_c)  # what libsurefoot_c.so, a link that is linked by, leads to
  string(APPEND development ", libsurefoot-c0 (= ${PROJECT_VERSION})")
endif()
surefoot_package(dev libsurefoot-dev libdevel "the library\n Headers, a static library, and what find_package and pkg-config find."
  "${development}")
surefoot_package(c libsurefoot-c0 libs "the library behind plain C\n A dozen functions for other languages; surefoot.h comes with libsurefoot-dev.")
set(interpreter python3)  # the compiled part is for one version of it
if(TARGET surefoot_python)
  get_target_property(minor surefoot_python SUREFOOT_PYTHON_MINOR)
  math(EXPR minor_after "${minor} + 1")
  set(interpreter "python3 (>= 3.${minor}), python3 (<< 3.${minor_after})")
endif()
surefoot_package(python python3-surefoot python "the Python module\n The library, readers, evaluation and simulation, over numpy's arrays."
  "${interpreter}, python3-numpy")

file(READ ${PROJECT_SOURCE_DIR}/LICENSE licence)
file(WRITE ${PROJECT_BINARY_DIR}/package/copyright
  "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\n"
  "Upstream-Name: surefoot\n\nFiles: *\nCopyright: 2026 The Surefoot authors\nLicense: Expat\n\n${licence}")
find_program(GZIP_PROGRAM gzip)
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${PROJECT_BINARY_DIR}/package/changelog
  "surefoot (${PROJECT_VERSION}) unstable; urgency=medium\n\n"
  "  * What changed stands in the sources' CHANGELOG.md.\n\n"
  " -- ${CPACK_PACKAGE_CONTACT}  ${now}\n")
execute_process(COMMAND ${GZIP_PROGRAM} -9nc ${PROJECT_BINARY_DIR}/package/changelog
  OUTPUT_FILE ${PROJECT_BINARY_DIR}/package/changelog.gz)
file(WRITE ${PROJECT_BINARY_DIR}/package/triggers "activate-noawait ldconfig\n")
file(CHMOD ${PROJECT_BINARY_DIR}/package/triggers PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
set(CPACK_DEBIAN_C_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/package/triggers)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/package_modes.cmake)
set(CPACK_POST_BUILD_SCRIPTS ${CPACK_PRE_BUILD_SCRIPTS})

include(CPack)
