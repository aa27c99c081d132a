# What the packages are made of: package/surefoot.spdx.json, in SPDX 2.3. Debian's packages as
# packages.txt lists them, in the versions that are installed here; what the page bundles, as
# web/package-lock.json says. Included after all targets; SOURCE_DATE_EPOCH sets its time.
set(sbom_packages)
set(sbom_relations)

function(surefoot_sbom_package id name version licence purl relation)
  set(packages "${sbom_packages},\n    {\"SPDXID\": \"SPDXRef-${id}\", \"name\": \"${name}\", \"versionInfo\": \"${version}\", \"downloadLocation\": \"NOASSERTION\", \"filesAnalyzed\": false, \"licenseConcluded\": \"NOASSERTION\", \"licenseDeclared\": \"${licence}\", \"copyrightText\": \"NOASSERTION\", \"externalRefs\": [{\"referenceCategory\": \"PACKAGE-MANAGER\", \"referenceType\": \"purl\", \"referenceLocator\": \"${purl}\"}]}")
  set(relations "${sbom_relations},\n    {\"spdxElementId\": \"SPDXRef-surefoot\", \"relationshipType\": \"${relation}\", \"relatedSpdxElement\": \"SPDXRef-${id}\"}")
  set(sbom_packages "${packages}" PARENT_SCOPE)
  set(sbom_relations "${relations}" PARENT_SCOPE)
endfunction()

# What a package is there for; those that are not named are for all of it.
set(sbom_if_libtbb-dev ${SUREFOOT_TBB})
set(sbom_if_libpcap-dev ${SUREFOOT_PCAP})
set(sbom_if_libembree-dev ${SUREFOOT_SIMULATION})
set(sbom_if_libceres-dev ${SUREFOOT_CERES})
set(sbom_if_libcairo2-dev ${SUREFOOT_PICTURES})
foreach(part libboost-dev=live_page cyclonedds-dev=ros2 pybind11-dev=python)
  string(REGEX MATCH "(.*)=(.*)" ignored ${part})
  if(TARGET surefoot_${CMAKE_MATCH_2})
    set(sbom_if_${CMAKE_MATCH_1} ON)
  else()
    set(sbom_if_${CMAKE_MATCH_1} OFF)
  endif()
endforeach()

find_program(DPKG_QUERY_PROGRAM dpkg-query)
file(STRINGS ${PROJECT_SOURCE_DIR}/cmake/packages.txt sbom_rows REGEX "^[a-z]")
foreach(row ${sbom_rows})
  string(REGEX MATCH "^[a-z]+ +([^ ]+) +([^ ]+) " ignored "${row}")
  set(name ${CMAKE_MATCH_1})
  set(licence ${CMAKE_MATCH_2})
  if(licence STREQUAL "-" OR (DEFINED sbom_if_${name} AND NOT sbom_if_${name}))
    continue()
  endif()
  set(version)
  if(DPKG_QUERY_PROGRAM)
    execute_process(COMMAND ${DPKG_QUERY_PROGRAM} --show --showformat=\${Version} ${name}
      OUTPUT_VARIABLE version ERROR_QUIET)
  endif()
  if(version)
    string(REPLACE "+" "%2B" encoded "${version}")
    string(REPLACE ":" "%3A" encoded "${encoded}")
    surefoot_sbom_package(deb-${name} ${name} ${version} ${licence} pkg:deb/debian/${name}@${encoded}
      DEPENDS_ON)
  endif()
endforeach()
if(SUREFOOT_PAGE)
  file(READ ${PROJECT_SOURCE_DIR}/web/package-lock.json lock)
  foreach(name three uplot 3d-tiles-renderer)
    string(JSON version GET "${lock}" packages node_modules/${name} version)
    string(JSON licence GET "${lock}" packages node_modules/${name} license)
    surefoot_sbom_package(npm-${name} ${name} ${version} ${licence} pkg:npm/${name}@${version} CONTAINS)
  endforeach()
endif()

string(TIMESTAMP sbom_time UTC)
file(WRITE ${PROJECT_BINARY_DIR}/package/surefoot.spdx.json "{
  \"spdxVersion\": \"SPDX-2.3\",
  \"dataLicense\": \"CC0-1.0\",
  \"SPDXID\": \"SPDXRef-DOCUMENT\",
  \"name\": \"surefoot-${PROJECT_VERSION}\",
  \"documentNamespace\": \"https://spdx.invalid/surefoot-${PROJECT_VERSION}/${sbom_time}\",
  \"creationInfo\": {\"created\": \"${sbom_time}\", \"creators\": [\"Tool: CMake-${CMAKE_VERSION}\"]},
  \"packages\": [
    {\"SPDXID\": \"SPDXRef-surefoot\", \"name\": \"surefoot\", \"versionInfo\": \"${PROJECT_VERSION}\", \"downloadLocation\": \"NOASSERTION\", \"filesAnalyzed\": false, \"licenseConcluded\": \"MIT\", \"licenseDeclared\": \"MIT\", \"copyrightText\": \"2026 The Surefoot authors\"}${sbom_packages}
  ],
  \"relationships\": [
    {\"spdxElementId\": \"SPDXRef-DOCUMENT\", \"relationshipType\": \"DESCRIBES\", \"relatedSpdxElement\": \"SPDXRef-surefoot\"}${sbom_relations}
  ]
}
")
