# Makes the pages that web/test looks at: -D program=... -D folder=... A walk of five seconds, run
# by two methods, one of them without map and truth.
function(surefoot output)
  execute_process(COMMAND ${program} ${ARGN} WORKING_DIRECTORY ${folder}
                  RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE complained)
  if(failed)
    message(FATAL_ERROR "surefoot ${ARGN}: ${failed}\n${said}${complained}")
  endif()
  set(${output} "${said}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
surefoot(said simulate campus --scans 50 --output walk)
surefoot(said convert walk walk.mcap)
surefoot(said run walk --quiet --output run)
surefoot(said run walk --quiet --output other --method paper)
# Few points, as the browser draws without a graphics card.
surefoot(said report run --output report.html --map-points 40000)
surefoot(said report run other --output comparison.html --map-points 10000)
surefoot(evaluation eval walk/gt.tum run/trajectory.tum --json)
file(WRITE ${folder}/evaluation.json "${evaluation}")
file(RENAME ${folder}/walk/gt.tum ${folder}/truth.tum)
surefoot(said run walk --quiet --no-map --count 20 --output bare)
if(NOT EXISTS ${folder}/run/report.html OR NOT EXISTS ${folder}/bare/report.html)
  message(FATAL_ERROR "surefoot run has left no report.html")
endif()
