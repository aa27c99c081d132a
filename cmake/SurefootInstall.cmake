# cmake --install: the library, its public headers and the package that find_package(surefoot)
# finds. The program installs itself. Nothing but include path, language level and the library's
# own dependencies is passed on to users: no warnings, no architecture, no -Werror.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/surefoot)

install(TARGETS surefoot EXPORT surefootTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/surefoot
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(EXPORT surefootTargets NAMESPACE surefoot:: DESTINATION ${package_dir})

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
  DESTINATION ${package_dir})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/surefoot)
