# Macros called by module files. Names and meanings match ITK's build, so a module folder also builds inside an ITK
# source tree; ITK's own macros do not work with an installed ITK.

include(GenerateExportHeader)
include(ShapetonITKTargets)
include(ShapetonOptions)
include(ShapetonTests)

# itk_module(<name> [ENABLE_SHARED] DEPENDS ... PRIVATE_DEPENDS ... COMPILE_DEPENDS ... TEST_DEPENDS ... DESCRIPTION "...")
# Called by itk-module.cmake; records the declaration. The name is Shapeton<Name>, because ITK's modules share one namespace; the
# target is Shapeton::<Name>.
macro(itk_module name)
  cmake_parse_arguments(_module "ENABLE_SHARED;EXCLUDE_FROM_DEFAULT" "DESCRIPTION"
    "DEPENDS;PRIVATE_DEPENDS;COMPILE_DEPENDS;TEST_DEPENDS;FACTORY_NAMES" ${ARGN})
  set(itk-module ${name})
  foreach(kind DEPENDS PRIVATE_DEPENDS COMPILE_DEPENDS TEST_DEPENDS)
    set(itk-module_${kind} ${_module_${kind}})
  endforeach()
endmacro()

# Links modules by name: Shapeton<Name> or <Name>, or a module of ITK.
function(shapeton_link_modules target scope)
  foreach(module IN LISTS ARGN)
    string(REGEX REPLACE "^Shapeton" "" name ${module})
    if(TARGET Shapeton::${name})
      target_link_libraries(${target} ${scope} Shapeton::${name})
    else()
      shapeton_itk_targets(${module})
      target_link_libraries(${target} ${scope} ITK::${module}Module)
    endif()
  endforeach()
endfunction()

# itk_module_add_library(<name> <sources...>): called by src/CMakeLists.txt.
function(itk_module_add_library name)
  add_library(${name} ${ARGN})
  generate_export_header(${name} EXPORT_FILE_NAME ${PROJECT_BINARY_DIR}/include/${name}Export.h
    EXPORT_MACRO_NAME ${name}_EXPORT NO_EXPORT_MACRO_NAME ${name}_HIDDEN STATIC_DEFINE ITK_STATIC)
  set_target_properties(${name} PROPERTIES
    UNITY_BUILD_BATCH_SIZE 32 CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    OUTPUT_NAME ${name}-${Shapeton_SERIES} VERSION ${Shapeton_VERSION} SOVERSION ${Shapeton_VERSION_MAJOR}
    INSTALL_RPATH "$ORIGIN") # installed modules find each other
  target_include_directories(${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>)
  shapeton_link_modules(${name} PUBLIC ${itk-module_DEPENDS} ${itk-module_COMPILE_DEPENDS})
  shapeton_link_modules(${name} PRIVATE ${itk-module_PRIVATE_DEPENDS})
  shapeton_precompile(${name})
  install(FILES ${PROJECT_BINARY_DIR}/include/${name}Export.h DESTINATION ${Shapeton_INSTALL_INCLUDE_DIR}
    COMPONENT Development)
endfunction()

# itk_module_impl(): called by the module's CMakeLists.txt after project() and find_package().
macro(itk_module_impl)
  if(EXISTS ${PROJECT_SOURCE_DIR}/src/CMakeLists.txt)
    if(NOT "${${itk-module}_LIBRARIES}" STREQUAL itk-module) # ITK's build links the module by this variable
      message(FATAL_ERROR "The module ${itk-module} does not set ${itk-module}_LIBRARIES to ${itk-module}.")
    endif()
    add_subdirectory(src)
    set(_scope PUBLIC)
  else()
    add_library(${itk-module} INTERFACE)
    target_include_directories(${itk-module} INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>)
    shapeton_link_modules(${itk-module} INTERFACE ${itk-module_DEPENDS} ${itk-module_COMPILE_DEPENDS})
    set(_scope INTERFACE)
  endif()
  string(REGEX REPLACE "^Shapeton" "" _name ${itk-module})
  set_target_properties(${itk-module} PROPERTIES EXPORT_NAME ${_name})
  add_library(Shapeton::${_name} ALIAS ${itk-module})
  target_compile_features(${itk-module} ${_scope} cxx_std_17)
  target_include_directories(${itk-module} ${_scope} $<INSTALL_INTERFACE:${Shapeton_INSTALL_INCLUDE_DIR}>)
  install(TARGETS ${itk-module} EXPORT ShapetonTargets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT Runtime NAMELINK_COMPONENT Development
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT Development)
  install(DIRECTORY include/ DESTINATION ${Shapeton_INSTALL_INCLUDE_DIR} COMPONENT Development
    FILES_MATCHING PATTERN "*.h" PATTERN "*.hxx")
  if(BUILD_TESTING)
    shapeton_header_self_compile_test(${itk-module})
    if(EXISTS ${PROJECT_SOURCE_DIR}/test/CMakeLists.txt)
      add_subdirectory(test)
    endif()
  endif()
endmacro()

# Checks that every public header compiles on its own and without warnings: one translation unit per header, built by the target
# HeaderTests.
function(shapeton_header_self_compile_test module)
  file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/*.h)
  set(sources "")
  foreach(header IN LISTS headers)
    get_filename_component(name ${header} NAME)
    set(source ${PROJECT_BINARY_DIR}/HeaderTest/${name}.cxx)
    file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${name}\"\n#include \"${name}\"\n")
    list(APPEND sources ${source})
  endforeach()
  if(sources)
    add_library(${module}HeaderTest OBJECT EXCLUDE_FROM_ALL ${sources})
    target_link_libraries(${module}HeaderTest PRIVATE ${module})
    target_compile_options(${module}HeaderTest PRIVATE -Wpedantic -Werror)
    set_target_properties(${module}HeaderTest PROPERTIES UNITY_BUILD OFF)
    if(NOT TARGET HeaderTests)
      add_custom_target(HeaderTests)
    endif()
    add_dependencies(HeaderTests ${module}HeaderTest)
  endif()
endfunction()

# ---- tests ----

# itk_module_test(): called first in test/CMakeLists.txt. ITKGoogleTest is used in ITK's build only; here GoogleTest is a separate
# package.
macro(itk_module_test)
  set(${itk-module}-Test_LIBRARIES ${itk-module})
  foreach(_dependency IN LISTS itk-module_TEST_DEPENDS)
    if(TARGET ${_dependency})
      list(APPEND ${itk-module}-Test_LIBRARIES ${_dependency})
    elseif(NOT _dependency STREQUAL "ITKGoogleTest")
      shapeton_itk_targets(${_dependency})
      list(APPEND ${itk-module}-Test_LIBRARIES ITK::${_dependency}Module)
    endif()
  endforeach()
endmacro()
