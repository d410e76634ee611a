# ITK::<Module>Module: one INTERFACE target for each ITK module, so that the DEPENDS of an itk-module.cmake can be
# linked by name and stay transitive. The ITK 5 packages carry no include directories on their targets; ITK 6 does.
# Installed with Shapeton, because a consumer's ITK needs the same targets.
function(shapeton_itk_targets)
  foreach(module IN LISTS ARGN)
    if(TARGET ITK::${module}Module)
      continue()
    endif()
    if(NOT module IN_LIST ITK_MODULES_ENABLED)
      message(FATAL_ERROR "This ITK has no module \"${module}\".")
    endif()
    itk_module_config(_shapeton_itk ${module})
    add_library(ITK::${module}Module INTERFACE IMPORTED GLOBAL)
    target_include_directories(ITK::${module}Module SYSTEM INTERFACE ${_shapeton_itk_INCLUDE_DIRS})
    target_link_libraries(ITK::${module}Module INTERFACE ${_shapeton_itk_LIBRARIES})
  endforeach()
endfunction()
