# Checks that dciodvfy finds no fault in the segmentation FILE.
if(NOT DCIODVFY)
  message("dciodvfy is not installed")
  return()
endif()
execute_process(COMMAND ${DCIODVFY} -new ${FILE} ERROR_VARIABLE said OUTPUT_VARIABLE said)
if(said MATCHES "Error|Warning" OR NOT said MATCHES "Segmentation")
  message(FATAL_ERROR "${FILE}: ${said}")
endif()
