# Checks that a project with only the language CXX finds Shapeton in its main file, in a function and in a subdirectory, and
# that after ITK's error about HDF5 a message names the remedy.
include(${CMAKE_CURRENT_LIST_DIR}/Consumers.cmake)
set(project "cmake_minimum_required(VERSION 3.22)\nproject(Languages LANGUAGES CXX)\n")
set(consumer "find_package(Shapeton ${VERSION} REQUIRED COMPONENTS Common)
add_executable(Consumer \"${SOURCE_DIR}/Examples/Voxels.cxx\")
target_link_libraries(Consumer PRIVATE Shapeton::Common)\n")

file(REMOVE_RECURSE "${WORK_DIR}")
file(WRITE "${WORK_DIR}/file/CMakeLists.txt" "${project}${consumer}")
file(WRITE "${WORK_DIR}/function/CMakeLists.txt" "${project}function(consume)\n${consumer}endfunction()\nconsume()\n")
file(WRITE "${WORK_DIR}/subdirectory/CMakeLists.txt" "${project}add_subdirectory(deeper)\n")
file(WRITE "${WORK_DIR}/subdirectory/deeper/CMakeLists.txt" "${consumer}")
foreach(place IN ITEMS file function subdirectory)
  configure("${WORK_DIR}/${place}" "${WORK_DIR}/build of ${place}" "-DCMAKE_PREFIX_PATH=${PREFIX}")
  run(${CMAKE_COMMAND} --build "${WORK_DIR}/build of ${place}")
endforeach()

file(WRITE "${WORK_DIR}/itk/CMakeLists.txt" "${project}find_package(ITK REQUIRED)\n${consumer}")
execute_process(COMMAND ${CMAKE_COMMAND} -S "${WORK_DIR}/itk" -B "${WORK_DIR}/build after itk" -G Ninja
  -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_PREFIX_PATH=${PREFIX}" OUTPUT_QUIET ERROR_VARIABLE errors RESULT_VARIABLE status)
if(errors MATCHES "HDF5" AND NOT errors MATCHES "LANGUAGES[ \n]+C[ \n]+CXX")
  message(FATAL_ERROR "the message does not name the remedy:\n${errors}")
elseif(NOT errors MATCHES "HDF5" AND NOT status EQUAL 0) # ITK has its own HDF5
  message(FATAL_ERROR "Shapeton is not found after ITK:\n${errors}")
endif()
