# Headers only.
set(proj Boost)
set(${proj}_DEPENDS "")
ExternalProject_Include_Dependencies(${proj} PROJECT_VAR proj)
ExternalProject_SetIfNotDefined(${SUPERBUILD_TOPLEVEL_PROJECT}_${proj}_URL
  https://archives.boost.io/release/1.86.0/source/boost_1_86_0.tar.bz2 QUIET)
ExternalProject_Add(${proj}
  ${${proj}_EP_ARGS}
  URL ${${SUPERBUILD_TOPLEVEL_PROJECT}_${proj}_URL}
  SOURCE_DIR ${CMAKE_BINARY_DIR}/${proj}
  CONFIGURE_COMMAND ""
  BUILD_COMMAND ""
  INSTALL_COMMAND ""
  DEPENDS ${${proj}_DEPENDS})
