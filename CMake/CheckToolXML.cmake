# Checks that --xml prints only the XML, within 3D Slicer's time limit.
execute_process(COMMAND ${TOOL} --xml OUTPUT_VARIABLE got ERROR_VARIABLE errors RESULT_VARIABLE status TIMEOUT 5)
file(READ ${XML} want)
if(NOT status EQUAL 0 OR NOT got STREQUAL want OR NOT errors STREQUAL "")
  message(FATAL_ERROR "--xml: status ${status}, stderr [${errors}], stdout differs from ${XML}:\n${got}")
endif()
