# With thread-local storage, as in Debian. Its headers are included as <nauty/...>.
set(proj nauty)
set(${proj}_DEPENDS "")
ExternalProject_Include_Dependencies(${proj} PROJECT_VAR proj)
ExternalProject_SetIfNotDefined(${SUPERBUILD_TOPLEVEL_PROJECT}_${proj}_URL
  https://pallini.di.uniroma1.it/nauty2_8_9.tar.gz QUIET)
set(flags "-O2 -fPIC ${ep_common_c_flags}")
ExternalProject_Add(${proj}
  ${${proj}_EP_ARGS}
  URL ${${SUPERBUILD_TOPLEVEL_PROJECT}_${proj}_URL}
  SOURCE_DIR ${CMAKE_BINARY_DIR}/${proj}
  BUILD_IN_SOURCE ON
  CONFIGURE_COMMAND ./configure --enable-tls --enable-generic "CC=${CMAKE_C_COMPILER}" "CFLAGS=${flags}"
  BUILD_COMMAND make nauty.a
  INSTALL_COMMAND sh -c "mkdir -p $1/include/nauty $1/lib && cp *.h $1/include/nauty && cp nauty.a $1/lib/libnauty.a"
    sh ${ep_prefix}
  DEPENDS ${${proj}_DEPENDS})
