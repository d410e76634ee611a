# torus.awk writes Torus.off.
execute_process(COMMAND ${AWK} -f ${DATA}/torus.awk OUTPUT_FILE ${OUT}/Torus.off RESULT_VARIABLE status)
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${OUT}/Torus.off ${DATA}/Torus.off RESULT_VARIABLE different)
if(NOT status EQUAL 0 OR NOT different EQUAL 0)
  message(FATAL_ERROR "${OUT}/Torus.off differs from ${DATA}/Torus.off")
endif()
