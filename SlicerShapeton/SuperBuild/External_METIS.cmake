# Same version as Debian: the elimination order, and thus the exact results, depend on it.
set(proj METIS)
set(${proj}_DEPENDS "")
ExternalProject_Include_Dependencies(${proj} PROJECT_VAR proj)
ExternalProject_SetIfNotDefined(${SUPERBUILD_TOPLEVEL_PROJECT}_${proj}_URL
  http://glaros.dtc.umn.edu/gkhome/fetch/sw/metis/metis-5.1.0.tar.gz QUIET)
ExternalProject_Add(${proj}
  ${${proj}_EP_ARGS}
  URL ${${SUPERBUILD_TOPLEVEL_PROJECT}_${proj}_URL}
  SOURCE_DIR ${CMAKE_BINARY_DIR}/${proj}
  BINARY_DIR ${CMAKE_BINARY_DIR}/${proj}-build
  CMAKE_CACHE_ARGS ${ep_compiler}
    -DCMAKE_INSTALL_PREFIX:PATH=${ep_prefix}
    -DCMAKE_POSITION_INDEPENDENT_CODE:BOOL=ON
    -DCMAKE_POLICY_VERSION_MINIMUM:STRING=3.5 # it asks for 2.8, which CMake 4 refuses
    -DGKLIB_PATH:PATH=${CMAKE_BINARY_DIR}/${proj}/GKlib
  DEPENDS ${${proj}_DEPENDS})
