# Differences between ITK 5.2 and 6.0 for CMake; shapetonITKCompatibility.h is the C++ counterpart. Installed with
# Shapeton, because consumers need the same targets.

# ITK::<Module>Module: one INTERFACE target for each ITK module, so that the DEPENDS of an itk-module.cmake can be
# linked by name and stay transitive. The targets of the ITK 5 packages lack include directories; those of ITK 6 have them.
function(shapeton_itk_targets)
  foreach(module IN LISTS ARGN)
    if(TARGET ITK::${module}Module)
      continue()
    endif()
    if(NOT module IN_LIST ITK_MODULES_ENABLED)
      message(FATAL_ERROR "ITK was built without the module \"${module}\".")
    endif()
    itk_module_config(_shapeton_itk ${module})
    add_library(ITK::${module}Module INTERFACE IMPORTED GLOBAL)
    target_include_directories(ITK::${module}Module SYSTEM INTERFACE ${_shapeton_itk_INCLUDE_DIRS})
    target_link_libraries(ITK::${module}Module INTERFACE ${_shapeton_itk_LIBRARIES})
  endforeach()
endfunction()

# Finds Eigen3::Eigen. The headers of ITK 6 include its bundled Eigen 5, so all other code must use that Eigen, too.
macro(shapeton_find_eigen)
  if(TARGET eigen_external) # inside ITK's source tree
    if(NOT TARGET Eigen3::Eigen)
      add_library(Eigen3::Eigen ALIAS eigen_external)
    endif()
  else()
    if(ITK_VERSION_MAJOR GREATER_EQUAL 6 AND ITKInternalEigen3_DIR)
      set(Eigen3_DIR ${ITKInternalEigen3_DIR})
    endif()
    find_package(Eigen3 REQUIRED NO_MODULE)
  endif()
endmacro()

# shapeton_link_eigen(<target> <scope>): links Eigen. The Eigen bundled with ITK 5 conflicts with the system's in one translation
# unit; ITK's headers use the system's if ITK_USE_SYSTEM_EIGEN is defined.
function(shapeton_link_eigen target scope)
  shapeton_find_eigen()
  target_link_libraries(${target} ${scope} Eigen3::Eigen)
  if(ITK_VERSION_MAJOR LESS 6)
    target_compile_definitions(${target} ${scope} ITK_USE_SYSTEM_EIGEN)
  endif()
endfunction()
