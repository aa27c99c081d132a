# Bundles web/ to the report's page and that of tiles, inside of C++ sources: SUREFOOT_PAGE_SOURCE, and
# to that of a live run: live_page_content.cpp beside them. That takes
# Node.js and npm, and once the network, from which `npm ci` brings the libraries that
# web/package-lock.json names. Where one of these is missing the program is built without the page.
# Included where that source is compiled.
#
# SUREFOOT_PAGE     whether there is a page
# SUREFOOT_NODE     the Node.js that bundles it
# SUREFOOT_WEB_DIR  where sources and node_modules lie together
set(SUREFOOT_WEB AUTO CACHE STRING "Bundle the report's page: AUTO (if Node.js and npm allow it), ON, OFF")
set_property(CACHE SUREFOOT_WEB PROPERTY STRINGS AUTO ON OFF)
set(SUREFOOT_WEB_DIR ${PROJECT_BINARY_DIR}/web CACHE INTERNAL "")
find_program(SUREFOOT_NODE NAMES node nodejs)
find_program(SUREFOOT_NPM NAMES npm)
mark_as_advanced(SUREFOOT_NODE SUREFOOT_NPM)

# Sets `problem` to why Node.js cannot be used, or to nothing.
function(surefoot_check_node problem)
  set(${problem} "" PARENT_SCOPE)
  if(NOT SUREFOOT_NODE OR NOT SUREFOOT_NPM)
    set(${problem} "no Node.js or no npm here" PARENT_SCOPE)
    return()
  endif()
  execute_process(COMMAND ${SUREFOOT_NODE} --version OUTPUT_VARIABLE version
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  string(REGEX REPLACE "^v" "" version "${version}")
  if(NOT version VERSION_GREATER_EQUAL 18)
    set(${problem} "Node.js is ${version}; 18 or later is needed" PARENT_SCOPE)
  endif()
endfunction()

# Brings node_modules to what package-lock.json says, and does nothing if it is. The browser's
# driver is for tests alone.
function(surefoot_install_node_modules problem)
  set(${problem} "" PARENT_SCOPE)
  set(lock ${PROJECT_SOURCE_DIR}/web/package-lock.json)
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${lock})
  set(omitted --omit=dev)
  if(SUREFOOT_TESTS)
    set(omitted)
  endif()
  file(SHA256 ${lock} wanted)
  string(APPEND wanted "${omitted}")
  set(stamp ${SUREFOOT_WEB_DIR}/node_modules/.surefoot_stamp)
  if(EXISTS ${stamp})
    file(READ ${stamp} present)
    if(present STREQUAL wanted)
      return()
    endif()
  endif()
  message(STATUS "Report's page: npm ci")
  file(COPY ${lock} ${PROJECT_SOURCE_DIR}/web/package.json DESTINATION ${SUREFOOT_WEB_DIR})
  execute_process(
    COMMAND ${SUREFOOT_NPM} ci ${omitted} --ignore-scripts --no-audit --no-fund
            --fetch-retries=1 --fetch-timeout=30000
    WORKING_DIRECTORY ${SUREFOOT_WEB_DIR} TIMEOUT 180
    RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(failed)
    set(${problem} "npm ci in ${SUREFOOT_WEB_DIR} failed (${failed}):\n${said}" PARENT_SCOPE)
    return()
  endif()
  file(WRITE ${stamp} "${wanted}")
endfunction()

function(surefoot_add_page)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/web/src/*)
  set(scripts ${PROJECT_SOURCE_DIR}/web/build.mjs ${PROJECT_SOURCE_DIR}/web/embed.mjs)
  add_custom_command(
    OUTPUT ${SUREFOOT_WEB_DIR}/page_template.cpp ${SUREFOOT_WEB_DIR}/tiles_page.cpp
           ${SUREFOOT_WEB_DIR}/live_page_content.cpp
    COMMAND ${CMAKE_COMMAND} -E copy_directory ${PROJECT_SOURCE_DIR}/web/src ${SUREFOOT_WEB_DIR}/src
    COMMAND ${CMAKE_COMMAND} -E copy ${scripts} ${SUREFOOT_WEB_DIR}
    COMMAND ${SUREFOOT_NODE} build.mjs report report.html
    COMMAND ${SUREFOOT_NODE} embed.mjs report.html page_template.cpp
            report/page.hpp report page_template
    COMMAND ${SUREFOOT_NODE} build.mjs live live.html
    COMMAND ${SUREFOOT_NODE} embed.mjs live.html live_page_content.cpp
            live_page/page_content.hpp live_page page_content
    COMMAND ${SUREFOOT_NODE} build.mjs tiles tiles.html
    COMMAND ${SUREFOOT_NODE} embed.mjs tiles.html tiles_page.cpp
            report/page.hpp report tiles_page
    WORKING_DIRECTORY ${SUREFOOT_WEB_DIR}
    DEPENDS ${sources} ${scripts} ${SUREFOOT_WEB_DIR}/node_modules/.surefoot_stamp
    COMMENT "Bundling the pages: report, live run, tiles" VERBATIM)
  set_source_files_properties(${SUREFOOT_WEB_DIR}/tiles_page.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

set(SUREFOOT_PAGE OFF CACHE INTERNAL "")
set(SUREFOOT_PAGE_SOURCE no_page_template.cpp)
if(SUREFOOT_WEB)
  surefoot_check_node(problem)
  if(NOT problem)
    surefoot_install_node_modules(problem)
  endif()
  if(NOT problem)
    surefoot_add_page()
    set(SUREFOOT_PAGE ON CACHE INTERNAL "")
    set(SUREFOOT_PAGE_SOURCE ${SUREFOOT_WEB_DIR}/page_template.cpp ${SUREFOOT_WEB_DIR}/tiles_page.cpp)
  elseif(SUREFOOT_WEB STREQUAL AUTO)
    message(STATUS "Report's page: left out: ${problem}")
  else()
    message(FATAL_ERROR "Report's page: ${problem}")
  endif()
endif()
