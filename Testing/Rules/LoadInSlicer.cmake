# Loads a tool in 3D Slicer: Slicer must find and parse its description and create a module.
#   cmake -DSlicer_EXECUTABLE=... -DTOOL=<executable> -DXML=<description> -DWORK_DIR=... -P LoadInSlicer.cmake
cmake_minimum_required(VERSION 3.22)

if(NOT Slicer_EXECUTABLE)
  set(Slicer_EXECUTABLE "$ENV{Slicer_EXECUTABLE}")
endif()
if(NOT Slicer_EXECUTABLE)
  message("Slicer_EXECUTABLE is not set")
  return()
endif()

# Use a folder with only this tool, because Slicer starts every executable that it finds.
file(REMOVE_RECURSE ${WORK_DIR})
file(COPY ${TOOL} ${XML} DESTINATION ${WORK_DIR})
get_filename_component(name ${TOOL} NAME)
find_program(XVFB_RUN xvfb-run)
if(NOT DEFINED ENV{DISPLAY} AND XVFB_RUN)
  set(display ${XVFB_RUN} -a)
endif()
execute_process(COMMAND ${display} ${Slicer_EXECUTABLE} --no-splash --no-main-window --ignore-slicerrc
  --additional-module-paths ${WORK_DIR} --python-script ${CMAKE_CURRENT_LIST_DIR}/LoadInSlicer.py ${name}
  OUTPUT_VARIABLE out ERROR_VARIABLE out RESULT_VARIABLE status TIMEOUT 300)
if(NOT status EQUAL 0 OR NOT out MATCHES "loaded ${name}")
  message(FATAL_ERROR "Slicer did not load ${name}; status ${status}\n${out}")
endif()
message("${out}")
