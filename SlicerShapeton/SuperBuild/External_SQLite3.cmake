# Same version as Debian, static.
set(proj SQLite3)
set(${proj}_DEPENDS "")
ExternalProject_Include_Dependencies(${proj} PROJECT_VAR proj)
ExternalProject_SetIfNotDefined(${SUPERBUILD_TOPLEVEL_PROJECT}_${proj}_URL
  https://www.sqlite.org/2022/sqlite-autoconf-3400100.tar.gz QUIET)
set(flags "-O2 -fPIC ${ep_common_c_flags}")
ExternalProject_Add(${proj}
  ${${proj}_EP_ARGS}
  URL ${${SUPERBUILD_TOPLEVEL_PROJECT}_${proj}_URL}
  SOURCE_DIR ${CMAKE_BINARY_DIR}/${proj}
  BUILD_IN_SOURCE ON
  CONFIGURE_COMMAND ./configure --disable-shared --prefix=${ep_prefix} "CC=${CMAKE_C_COMPILER}" "CFLAGS=${flags}"
  BUILD_COMMAND make libsqlite3.la
  INSTALL_COMMAND make install-libLTLIBRARIES install-includeHEADERS
  DEPENDS ${${proj}_DEPENDS})
