# Builds the dependencies missing in Slicer, then Shapeton, then this project again as "inner".
set(ep_common_c_flags "${CMAKE_C_FLAGS_INIT} ${ADDITIONAL_C_FLAGS}")
set(ep_common_cxx_flags "${CMAKE_CXX_FLAGS_INIT} ${ADDITIONAL_CXX_FLAGS}")
set(ep_compiler
  -DCMAKE_C_COMPILER:FILEPATH=${CMAKE_C_COMPILER}
  -DCMAKE_C_FLAGS:STRING=${ep_common_c_flags}
  -DCMAKE_CXX_COMPILER:FILEPATH=${CMAKE_CXX_COMPILER}
  -DCMAKE_CXX_FLAGS:STRING=${ep_common_cxx_flags}
  -DCMAKE_BUILD_TYPE:STRING=${CMAKE_BUILD_TYPE})
set(ep_prefix ${CMAKE_BINARY_DIR}/prefix) # of what is linked into Shapeton

# simple_project(<name> VERSION <tag> GIT <repository> [CACHE <-D...>...]): built by CMake and installed to ep_prefix.
# To use another repository and tag: -Dinner_<name>_GIT_REPOSITORY=... -Dinner_<name>_GIT_TAG=...
function(simple_project name)
  cmake_parse_arguments(PARSE_ARGV 1 project "" "VERSION;GIT" "CACHE")
  ExternalProject_SetIfNotDefined(${SUPERBUILD_TOPLEVEL_PROJECT}_${name}_GIT_REPOSITORY ${project_GIT} QUIET)
  ExternalProject_SetIfNotDefined(${SUPERBUILD_TOPLEVEL_PROJECT}_${name}_GIT_TAG ${project_VERSION} QUIET)
  ExternalProject_Add(${name}
    ${${name}_EP_ARGS}
    GIT_REPOSITORY ${${SUPERBUILD_TOPLEVEL_PROJECT}_${name}_GIT_REPOSITORY}
    GIT_TAG ${${SUPERBUILD_TOPLEVEL_PROJECT}_${name}_GIT_TAG}
    SOURCE_DIR ${CMAKE_BINARY_DIR}/${name}
    BINARY_DIR ${CMAKE_BINARY_DIR}/${name}-build
    CMAKE_CACHE_ARGS ${ep_compiler} -DCMAKE_INSTALL_PREFIX:PATH=${ep_prefix} -DBUILD_TESTING:BOOL=OFF ${project_CACHE}
    DEPENDS ${${name}_DEPENDS})
endfunction()

set(proj ${SUPERBUILD_TOPLEVEL_PROJECT})
set(${proj}_DEPENDS Shapeton)
ExternalProject_Include_Dependencies(${proj} PROJECT_VAR proj SUPERBUILD_VAR ${EXTENSION_NAME}_SUPERBUILD)
ExternalProject_Add(${proj}
  ${${proj}_EP_ARGS}
  DOWNLOAD_COMMAND ""
  INSTALL_COMMAND ""
  SOURCE_DIR ${CMAKE_CURRENT_SOURCE_DIR}
  BINARY_DIR ${EXTENSION_BUILD_SUBDIRECTORY}
  CMAKE_CACHE_ARGS
    ${ep_compiler}
    -D${EXTENSION_NAME}_SUPERBUILD:BOOL=OFF
    -DEXTENSION_SUPERBUILD_BINARY_DIR:PATH=${${EXTENSION_NAME}_BINARY_DIR}
  DEPENDS ${${proj}_DEPENDS})
ExternalProject_AlwaysConfigure(${proj})
