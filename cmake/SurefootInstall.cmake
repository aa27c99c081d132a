# cmake --install: the library, its public headers and the package that find_package(surefoot)
# finds. The program installs itself. Nothing but include path, language level and the library's
# own dependencies is passed on to users: no warnings, no architecture, no -Werror.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/surefoot)

install(TARGETS surefoot EXPORT surefootTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/surefoot
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev FILES_MATCHING PATTERN "*.hpp")
install(EXPORT surefootTargets NAMESPACE surefoot:: DESTINATION ${package_dir} COMPONENT dev)

# The component mapping, for who asks for it: it links Ceres, which the library itself does not.
if(TARGET surefoot_mapping)
  install(TARGETS surefoot_mapping EXPORT surefootMappingTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT surefootMappingTargets NAMESPACE surefoot:: DESTINATION ${package_dir} COMPONENT dev)
endif()

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/surefootConfig.cmake.in
  ${PROJECT_BINARY_DIR}/package/surefootConfig.cmake
  INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
# Before 1.0 a minor version may break the API.
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/package/surefootConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/package/surefootConfig.cmake
  ${PROJECT_BINARY_DIR}/package/surefootConfigVersion.cmake
  DESTINATION ${package_dir} COMPONENT dev)
set(pc_requires eigen3)
if(SUREFOOT_TBB)
  string(APPEND pc_requires ", tbb")
endif()
set(pc_threads "")
if(SUREFOOT_STD_THREADS)
  set(pc_threads " -pthread")
endif()
# From where the file lies back to the prefix, wherever that is put.
file(RELATIVE_PATH pc_up /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
foreach(name surefoot surefoot_c)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/${name}.pc.in ${PROJECT_BINARY_DIR}/package/${name}.pc @ONLY)
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/package/surefoot.pc
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)
if(TARGET surefoot_c)
  install(FILES ${PROJECT_BINARY_DIR}/package/surefoot_c.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)
endif()
include(SurefootPackages)
