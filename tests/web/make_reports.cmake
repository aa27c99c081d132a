# Makes the pages that web/test looks at: -D program=... -D folder=... A walk of five seconds, run
# by two methods, one of them without map and truth, and its map as tiles.
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
surefoot(said map walk --quiet --no-report --no-picture --output map)
surefoot(said export map --tiles tiles --tiles-at 48.1 11.6 520 30)
surefoot(said run walk --quiet --output run)
surefoot(said run walk --quiet --output other --method paper)
surefoot(said run walk --quiet --no-picture --count 1 --output single)
# Few points, as the browser draws without a graphics card.
surefoot(said report run --output report.html --map-points 40000)
surefoot(said report run other --output comparison.html --map-points 10000)
# A run with loops, as `surefoot map` leaves it: the walk is too short for one of its own.
file(COPY ${folder}/run/ DESTINATION ${folder}/looped)
file(STRINGS ${folder}/run/trajectory.tum poses REGEX "^[^#]")
list(GET poses 0 first)
list(GET poses -1 last)
string(REGEX REPLACE " .*" "" first "${first}")
string(REGEX REPLACE " .*" "" last "${last}")
file(WRITE ${folder}/looped/loops.csv
  "stamp,place_stamp,verdict,why\n${last},${first},taken,every question was answered with yes\n"
  "${last},${first},free_space,something stands where the other saw nothing\n")
file(COPY_FILE ${folder}/looped/trajectory.tum ${folder}/looped/trajectory_optimized.tum)
surefoot(said report looped --output looped.html --map-points 10000)
# Five seconds are a nearly straight way, which the page's figures align by poses.
surefoot(evaluation eval walk/gt.tum run/trajectory.tum --pair interpolate --align poses --json)
file(WRITE ${folder}/evaluation.json "${evaluation}")
file(RENAME ${folder}/walk/gt.tum ${folder}/truth.tum)
# A recording that a run would suffer of: check ends with 1.
file(COPY ${folder}/walk/ DESTINATION ${folder}/damaged)
file(WRITE ${folder}/damaged/000007.pcd "no scan")
execute_process(COMMAND ${program} check damaged --html check.html --quiet
                WORKING_DIRECTORY ${folder} OUTPUT_QUIET)
surefoot(said run walk --quiet --no-map --count 20 --output bare)
if(NOT EXISTS ${folder}/run/report.html OR NOT EXISTS ${folder}/bare/report.html
   OR NOT EXISTS ${folder}/check.html)
  message(FATAL_ERROR "surefoot has left no page")
endif()
