# Shared functions of the scripts in this folder, which ctest calls. They read
#   BUILD_DIR, COMPILER, BUILD_TYPE, SANITIZE   settings of the tested build
#   SOURCE_DIR                                  the repository
#   WORK_DIR                                    the test's folder, which may be removed
cmake_minimum_required(VERSION 3.22)

# run(<command...>): runs a command and sets `out` to its output; aborts the test if the command fails.
function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE out ERROR_VARIABLE errors RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "status ${status}: ${ARGN}\n${out}\n${errors}")
  endif()
  set(out "${out}" PARENT_SCOPE)
endfunction()

# expect(<regex>): checks the output of the last run.
function(expect regex)
  if(NOT out MATCHES "${regex}")
    message(FATAL_ERROR "[${out}] does not match ${regex}")
  endif()
endfunction()

# Installs with DESTDIR under a name with a space and moves the result: a package must be independent of its build and install location.
function(install_moved prefix)
  file(REMOVE_RECURSE "${WORK_DIR}/stage" "${prefix}")
  run(${CMAKE_COMMAND} -E env "DESTDIR=${WORK_DIR}/stage" ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix "/opt/of one")
  get_filename_component(folder "${prefix}" DIRECTORY)
  file(MAKE_DIRECTORY "${folder}")
  file(RENAME "${WORK_DIR}/stage/opt/of one" "${prefix}")
endfunction()

# configure(<source> <build> <arguments...>): configures with the compiler of the tested build.
function(configure source build)
  set(flags "")
  if(SANITIZE)
    set(flags "-fsanitize=${SANITIZE}")
  endif()
  run(${CMAKE_COMMAND} -S "${source}" -B "${build}" -G Ninja -DCMAKE_CXX_COMPILER=${COMPILER}
    -DCMAKE_BUILD_TYPE=${BUILD_TYPE} "-DCMAKE_CXX_FLAGS=${flags}" ${ARGN})
endfunction()

# consume(<prefix> <build> <version> <module>,<module>... <program of Examples/>): builds Component/ against an installation.
function(consume prefix build version modules program)
  file(REMOVE_RECURSE "${build}")
  configure("${SOURCE_DIR}/Testing/Consumer/Component" "${build}" "-DCMAKE_PREFIX_PATH=${prefix}" -DVERSION=${version}
    "-DMODULES=${modules}" -DSOURCE=${SOURCE_DIR}/Examples/${program}.cxx)
  run(${CMAKE_COMMAND} --build "${build}")
endfunction()
