# The installed package: find_package(Shapeton).
include(CMakePackageConfigHelpers)
get_property(Shapeton_ITK_MODULES GLOBAL PROPERTY SHAPETON_ITK_MODULES)
list(REMOVE_DUPLICATES Shapeton_ITK_MODULES)
configure_package_config_file(CMake/ShapetonConfig.cmake.in ${PROJECT_BINARY_DIR}/ShapetonConfig.cmake
  INSTALL_DESTINATION ${Shapeton_INSTALL_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ShapetonConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ShapetonConfig.cmake ${PROJECT_BINARY_DIR}/ShapetonConfigVersion.cmake
  CMake/ShapetonITKTargets.cmake DESTINATION ${Shapeton_INSTALL_CMAKE_DIR})
install(EXPORT ShapetonTargets NAMESPACE Shapeton:: DESTINATION ${Shapeton_INSTALL_CMAKE_DIR})
