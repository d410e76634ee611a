# Same version as Debian, static.
set(proj BZip2)
set(${proj}_DEPENDS "")
ExternalProject_Include_Dependencies(${proj} PROJECT_VAR proj)
ExternalProject_SetIfNotDefined(${SUPERBUILD_TOPLEVEL_PROJECT}_${proj}_URL
  https://sourceware.org/pub/bzip2/bzip2-1.0.8.tar.gz QUIET)
set(flags "-O2 -fPIC ${ep_common_c_flags}")
ExternalProject_Add(${proj}
  ${${proj}_EP_ARGS}
  URL ${${SUPERBUILD_TOPLEVEL_PROJECT}_${proj}_URL}
  SOURCE_DIR ${CMAKE_BINARY_DIR}/${proj}
  BUILD_IN_SOURCE ON
  CONFIGURE_COMMAND ""
  BUILD_COMMAND make libbz2.a "CC=${CMAKE_C_COMPILER}" "CFLAGS=${flags}"
  INSTALL_COMMAND sh -c "mkdir -p $1/include $1/lib && cp bzlib.h $1/include && cp libbz2.a $1/lib" sh ${ep_prefix}
  DEPENDS ${${proj}_DEPENDS})
