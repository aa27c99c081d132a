# Brings the libraries, makes the files, and has them read: -D program=... -D folder=... -D node=...
# -D npm=...
if(NOT node OR NOT npm)
  message("SKIPPED: no Node.js or no npm here")
  return()
endif()

function(must_run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${folder}/bags
                  RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(failed)
    message(FATAL_ERROR "${ARGN}: ${failed}\n${said}")
  endif()
endfunction()

file(SHA256 ${CMAKE_CURRENT_LIST_DIR}/package-lock.json wanted)
set(stamp ${folder}/node_modules/.surefoot_stamp)
set(present)
if(EXISTS ${stamp})
  file(READ ${stamp} present)
endif()
if(NOT present STREQUAL wanted)
  file(COPY ${CMAKE_CURRENT_LIST_DIR}/package.json ${CMAKE_CURRENT_LIST_DIR}/package-lock.json
       DESTINATION ${folder})
  execute_process(
    COMMAND ${npm} ci --ignore-scripts --no-audit --no-fund --fetch-retries=1 --fetch-timeout=30000
    WORKING_DIRECTORY ${folder} TIMEOUT 180
    RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(failed)
    message("SKIPPED: npm ci failed (${failed}):\n${said}")
    return()
  endif()
  file(WRITE ${stamp} "${wanted}")
endif()
file(COPY ${CMAKE_CURRENT_LIST_DIR}/read_bags.test.mjs DESTINATION ${folder})

file(REMOVE_RECURSE ${folder}/bags)
file(MAKE_DIRECTORY ${folder}/bags)
must_run(${program} simulate campus --scans 50 --output walk)
must_run(${program} run walk --quiet --output run --mcap run.mcap)
must_run(${program} convert walk walk.mcap)
must_run(${program} convert walk walk.bag)

execute_process(COMMAND ${CMAKE_COMMAND} -E env SUREFOOT_TEST_BAGS=${folder}/bags
                        ${node} --test read_bags.test.mjs
                WORKING_DIRECTORY ${folder} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "reading failed (${failed})")
endif()
