# The installed package for find_package(Shapeton), and the cpack packages.
include(CMakePackageConfigHelpers)
include(ShapetonNeeds)
configure_package_config_file(CMake/ShapetonConfig.cmake.in ${PROJECT_BINARY_DIR}/ShapetonConfig.cmake
  INSTALL_DESTINATION ${Shapeton_INSTALL_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ShapetonConfigVersion.cmake COMPATIBILITY SameMinorVersion)
shapeton_write_needs(${PROJECT_BINARY_DIR}/ShapetonNeeds.cmake)
install(FILES ${PROJECT_BINARY_DIR}/ShapetonConfig.cmake ${PROJECT_BINARY_DIR}/ShapetonConfigVersion.cmake
  ${PROJECT_BINARY_DIR}/ShapetonNeeds.cmake CMake/ShapetonITKTargets.cmake
  DESTINATION ${Shapeton_INSTALL_CMAKE_DIR} COMPONENT Development)
install(EXPORT ShapetonTargets NAMESPACE Shapeton:: DESTINATION ${Shapeton_INSTALL_CMAKE_DIR} COMPONENT Development)
install(FILES LICENSE NOTICE DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/Shapeton-${Shapeton_SERIES} COMPONENT Runtime)

# ---- Debian packages: cpack -G DEB ----
set(CPACK_PACKAGE_NAME shapeton)
set(CPACK_PACKAGE_VENDOR "The Shapeton developers")
# The domain "invalid" is reserved: whoever distributes the packages sets an address.
set(SHAPETON_PACKAGE_CONTACT "The Shapeton developers <developers@shapeton.invalid>" CACHE STRING
  "Maintainer of the Debian packages: NAME <ADDRESS>")
set(CPACK_PACKAGE_CONTACT "${SHAPETON_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL Runtime Tools Development)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENT_TOOLS_DEPENDS Runtime)
set(CPACK_COMPONENT_DEVELOPMENT_DEPENDS Runtime)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "The libraries of Shapeton.")
set(CPACK_COMPONENT_TOOLS_DESCRIPTION "The command-line tools of Shapeton, which are also modules of 3D Slicer.")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "The headers of Shapeton and its CMake package.")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libshapeton${Shapeton_SERIES})
set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME shapeton)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libshapeton${Shapeton_SERIES}-dev)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON) # of the same version
set(CPACK_DEBIAN_TOOLS_PACKAGE_RECOMMENDS weasyprint) # report.pdf
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}) # our own libraries are not dependencies on other packages
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libinsighttoolkit5-dev, libvtk9-dev, libeigen3-dev, nlohmann-json3-dev")
if(SHAPETON_CUDA)
  list(APPEND CPACK_COMPONENTS_ALL Cuda)
  set(CPACK_COMPONENT_CUDA_DEPENDS Runtime)
  set(CPACK_COMPONENT_CUDA_DESCRIPTION "The Shapeton plug-in for NVIDIA GPUs, including the CUDA runtime.")
  set(CPACK_DEBIAN_CUDA_PACKAGE_NAME libshapeton${Shapeton_SERIES}-cuda)
endif()

# Files that Debian requires in each package.
set(folder ${PROJECT_BINARY_DIR}/debian)
file(READ NOTICE notice)
file(CONFIGURE OUTPUT ${folder}/copyright CONTENT [[
Copyright The Shapeton developers

Licensed under the Apache License, Version 2.0; on Debian systems, see /usr/share/common-licenses/Apache-2.0.

@notice@]] @ONLY)
file(CONFIGURE OUTPUT ${folder}/changelog CONTENT [[
shapeton (@Shapeton_VERSION@) unstable; urgency=medium

  * New version; its source package contains CHANGELOG.md.

 -- @SHAPETON_PACKAGE_CONTACT@  @Shapeton_DATE@
]] @ONLY)
execute_process(COMMAND gzip -9n INPUT_FILE ${folder}/changelog OUTPUT_FILE ${folder}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${folder}/triggers "activate-noawait ldconfig\n")
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  install(FILES ${folder}/copyright ${folder}/changelog.gz COMPONENT ${component}
    DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
endforeach()
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${folder}/triggers)
include(CPack)
