# The licences of others whose code is within our programs and libraries, as these licences ask for:
# package/notices.txt. What is linked when the program begins has its own package, with its licence.
# Included after SurefootSbom, whose sbom_if_... say what is not used.
set(inside libeigen3-dev libcli11-dev nlohmann-json3-dev libceres-dev libboost-dev pybind11-dev)  # headers, libceres.a
set(notices ${PROJECT_BINARY_DIR}/package/notices.txt)
file(WRITE ${notices} "Within Surefoot's programs and libraries are parts of the following.\n")

function(surefoot_notice name file)
  if(NOT EXISTS ${file})
    message(STATUS "Packages: ${file} is not here, its licence is missing in notices.txt")
    return()
  endif()
  file(READ ${file} text)
  file(APPEND ${notices} "\n==== ${name} ====\n\n${text}\n")
endfunction()

foreach(name ${inside})
  if(NOT DEFINED sbom_if_${name} OR sbom_if_${name})
    surefoot_notice(${name} /usr/share/doc/${name}/copyright)
  endif()
endforeach()
if(SUREFOOT_PAGE)
  foreach(name three uplot 3d-tiles-renderer)
    surefoot_notice(${name} ${SUREFOOT_WEB_DIR}/node_modules/${name}/LICENSE)
  endforeach()
endif()
