# Resumes a finished run with --dicomResults. Checks that earlier stages are not recomputed, and that the objects equal
# the objects that the tool writes.
file(REMOVE_RECURSE ${OUT} ${OUT}-single)
file(COPY ${FINISHED}/ DESTINATION ${OUT})
file(READ ${OUT}/stages/polyps.json before)
execute_process(COMMAND ${TOOL} ${INPUT} ${OUT} --faces 20000 --dicomResults --ohif --fhir RESULT_VARIABLE status ERROR_VARIABLE error OUTPUT_QUIET)
file(READ ${OUT}/stages/polyps.json after)
if(NOT status EQUAL 0 OR NOT before STREQUAL after)
  message(FATAL_ERROR "status ${status}: ${error}")
endif()
execute_process(COMMAND ${SINGLE} ${OUT} ${OUT}-single --source ${INPUT} --ohif --fhir RESULT_VARIABLE status ERROR_VARIABLE error OUTPUT_QUIET)
foreach(object seg.dcm seg-anatomy.dcm sr.dcm sr-ohif.dcm cad.dcm sc.dcm stl.dcm fhir.json)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${OUT}/dicom/${object} ${OUT}-single/${object}
    RESULT_VARIABLE differs)
  if(NOT status EQUAL 0 OR differs)
    message(FATAL_ERROR "${object} of the stage differs from the tool's: ${error}")
  endif()
endforeach()
