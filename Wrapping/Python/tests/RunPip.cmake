# Installs the package by pip without an index into a folder with a blank in its name, and imports it.
# Shapeton is found in INSTALLED, or installed from BUILD_DIR, or built with the package.
function(run)
  # Python searches modules in the working folder first.
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK_DIR} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN} failed:\n${output}")
  endif()
endfunction()

execute_process(COMMAND ${PYTHON} -c "import setuptools, pip, wheel" RESULT_VARIABLE status ERROR_QUIET)
if(NOT status EQUAL 0)
  message(STATUS "pip is not installed")
  return()
endif()
file(REMOVE_RECURSE ${WORK_DIR})
get_filename_component(repository ${CMAKE_CURRENT_LIST_DIR}/../../.. ABSOLUTE)
foreach(part IN ITEMS setup.py pyproject.toml CMakeLists.txt CMake LICENSE NOTICE Modules Wrapping) # pip writes beside them
  file(COPY ${repository}/${part} DESTINATION ${WORK_DIR}/source)
endforeach()
set(environment --unset=Shapeton_ROOT)
if(BUILD_DIR)
  run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix)
  set(environment Shapeton_ROOT=${WORK_DIR}/prefix)
elseif(INSTALLED) # CMake finds a package from the folder of its configuration upwards
  set(environment Shapeton_ROOT=${INSTALLED})
endif()
run(${CMAKE_COMMAND} -E env ${environment} ${PYTHON} -m pip install --no-index --no-build-isolation
  --target "${WORK_DIR}/a target" ${WORK_DIR}/source)
file(REMOVE_RECURSE ${WORK_DIR}/source)
# A script, because the semicolons of a command would separate arguments. Reading starts the program ShapetonFileParser of the
# package or of the installation.
file(WRITE ${WORK_DIR}/use.py "import numpy
import shapeton

assert 'a target' in shapeton.__file__
assert list(shapeton.recorded_steps(8, 3, 'linear')) == [0, 4, 8]
shapeton.write_volume(shapeton.Image(numpy.ones((3, 4, 5), numpy.float32)), 'volume.nrrd')
assert (shapeton.read_volume('volume.nrrd').array == 1).all()
")
run(${CMAKE_COMMAND} -E env "PYTHONPATH=${WORK_DIR}/a target" ${PYTHON} ${WORK_DIR}/use.py)
