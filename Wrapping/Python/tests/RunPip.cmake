# Installs the package by pip without an index, and imports it, in every way and one after the other from the same folder:
# against an installed Shapeton, with the libraries inside, and again against the installed Shapeton, in a virtual environment.
# Shapeton is installed from BUILD_DIR, or found from INSTALLED, the folder of its CMake configuration, upwards.
function(run)
  # Python searches modules in the working folder first.
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK_DIR} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN} failed:\n${output}")
  endif()
endfunction()

# install(<environment of pip> <environment of Python> <Python> [<arguments of pip>...])
function(install pip_environment environment python)
  run(${CMAKE_COMMAND} -E env ${pip_environment} ${python} -m pip install --no-index --no-build-isolation ${ARGN}
    ${WORK_DIR}/source)
  file(RENAME ${WORK_DIR}/source ${WORK_DIR}/hidden) # the installed package must not need it
  run(${CMAKE_COMMAND} -E env ${environment} ${python} ${WORK_DIR}/use.py)
  file(RENAME ${WORK_DIR}/hidden ${WORK_DIR}/source)
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
if(BUILD_DIR)
  run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix)
  set(INSTALLED ${WORK_DIR}/prefix)
endif()
# A script, because the semicolons of a command would separate arguments. Reading starts the program ShapetonFileParser of the
# package or of the installation.
file(WRITE ${WORK_DIR}/use.py "import numpy
import shapeton

assert shapeton.__file__.startswith('${WORK_DIR}/a '), shapeton.__file__
assert list(shapeton.recorded_steps(8, 3, 'linear')) == [0, 4, 8]
shapeton.write_volume(shapeton.Image(numpy.ones((3, 4, 5), numpy.float32)), 'volume.nrrd')
assert (shapeton.read_volume('volume.nrrd').array == 1).all()
")
install("Shapeton_ROOT=${INSTALLED}" "PYTHONPATH=${WORK_DIR}/a target" ${PYTHON} --target "${WORK_DIR}/a target")
install(--unset=Shapeton_ROOT "PYTHONPATH=${WORK_DIR}/a second target" ${PYTHON} --target "${WORK_DIR}/a second target")
run(${PYTHON} -m venv --system-site-packages --without-pip "${WORK_DIR}/a venv")
install("Shapeton_ROOT=${INSTALLED}" --unset=PYTHONPATH "${WORK_DIR}/a venv/bin/python")
file(GLOB_RECURSE parser "${WORK_DIR}/a venv/*/ShapetonFileParser")
if(parser)
  message(FATAL_ERROR "${parser} is left from the package with the libraries inside")
endif()
