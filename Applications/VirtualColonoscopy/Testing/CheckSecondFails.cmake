# Called by ctest: an invalid second series; the first is kept, and the report states the failure.
file(REMOVE_RECURSE ${OUT})
file(COPY ${FINISHED}/ DESTINATION ${OUT})
execute_process(COMMAND ${TOOL} ${INPUT} ${OUT} --second ${SECOND} --inputIsLumen --faces 20000 --quiet
  RESULT_VARIABLE status ERROR_VARIABLE error)
if(NOT status EQUAL 3 OR NOT error MATCHES "of the second series failed: .*; kept: nothing, report.html")
  message(FATAL_ERROR "status ${status}: ${error}")
endif()
file(READ ${OUT}/report.html text)
string(FIND "${text}" "of the second series failed" place)
if(place EQUAL -1)
  message(FATAL_ERROR "report.html does not report that the second series failed")
endif()
