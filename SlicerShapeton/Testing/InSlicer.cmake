# Runs in_slicer.py in 3D Slicer with all tools and modules.
#   cmake -DSlicer_EXECUTABLE=... -DTOOLS=<folder of the tools> -DPATIENT=<DICOM series> -DWORK_DIR=... -P InSlicer.cmake
cmake_minimum_required(VERSION 3.22)

if(NOT Slicer_EXECUTABLE)
  message("skipped: Slicer_EXECUTABLE is not set")
  return()
endif()

# Links to the tools only, because Slicer starts every executable that it finds.
file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR}/tools)
file(GLOB descriptions ${TOOLS}/*.xml)
foreach(xml IN LISTS descriptions)
  get_filename_component(tool ${xml} NAME_WE)
  file(CREATE_LINK ${xml} ${WORK_DIR}/tools/${tool}.xml SYMBOLIC)
  file(CREATE_LINK ${TOOLS}/${tool} ${WORK_DIR}/tools/${tool} SYMBOLIC)
endforeach()

find_program(XVFB_RUN xvfb-run)
if(NOT DEFINED ENV{DISPLAY} AND XVFB_RUN)
  set(display ${XVFB_RUN} -a -s "-screen 0 1600x1000x24 +extension GLX")
endif()
get_filename_component(extension ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
set(ENV{PYTHONPATH} ${extension})
set(ENV{PYTHONFAULTHANDLER} 1)
set(ENV{SHAPETON_TOOLS} ${TOOLS})
set(ENV{SHAPETON_PATIENT} ${PATIENT})
execute_process(
  COMMAND ${display} ${Slicer_EXECUTABLE} --testing --no-splash --ignore-slicerrc --disable-settings
    --additional-module-paths ${WORK_DIR}/tools ${extension}/ShapetonHeat ${extension}/ShapetonColonoscopy
    --python-script ${CMAKE_CURRENT_LIST_DIR}/in_slicer.py ${WORK_DIR}
  OUTPUT_FILE ${WORK_DIR}/log ERROR_FILE ${WORK_DIR}/log RESULT_VARIABLE status TIMEOUT 1700)
file(READ ${WORK_DIR}/log log)
string(REGEX MATCHALL "\n(ok|FAILED) [^\n]*" results "\n${log}")
string(CONCAT results ${results})
message("${results}")
if(NOT status EQUAL 0 OR NOT log MATCHES "all tests passed in Slicer")
  message(FATAL_ERROR "3D Slicer: status ${status}; see ${WORK_DIR}/log")
endif()
