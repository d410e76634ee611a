# Installs the package by pip without an index, into a folder with a blank in its name, and imports it from there.
# Shapeton is the one that INSTALLED was found in, or else the build BUILD_DIR, which is installed here.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN} failed:\n${output}")
  endif()
endfunction()

execute_process(COMMAND ${PYTHON} -c "import pip, setuptools, wheel" RESULT_VARIABLE status ERROR_QUIET)
if(NOT status EQUAL 0)
  message(STATUS "pip is not installed")
  return()
endif()
file(REMOVE_RECURSE ${WORK_DIR})
file(COPY ${SOURCE}/ DESTINATION ${WORK_DIR}/source) # pip writes into the folder that it builds
set(prefix ${INSTALLED}) # CMake finds a package from the folder of its configuration upwards
if(BUILD_DIR)
  set(prefix ${WORK_DIR}/prefix)
  run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})
endif()
run(${CMAKE_COMMAND} -E env "CMAKE_PREFIX_PATH=${prefix}" ${PYTHON} -m pip install --no-index --no-build-isolation
  --target "${WORK_DIR}/a target" ${WORK_DIR}/source)
run(${CMAKE_COMMAND} -E env "PYTHONPATH=${WORK_DIR}/a target" ${PYTHON} -c
  "import shapeton; assert 'a target' in shapeton.__file__; assert shapeton.recorded_steps(8, 3, 'linear') == [0, 4, 8]")
