# Checks that modified or outdated results of a run are rejected, and that without a search, the CAD report does not
# claim that there are no candidates.
file(REMOVE_RECURSE ${OUT})
file(COPY ${EXAM}/ DESTINATION ${OUT}/exam)

function(expect_status expected message)
  execute_process(COMMAND ${TOOL} ${OUT}/exam ${OUT}/objects --source ${SERIES} --quiet
    RESULT_VARIABLE status ERROR_VARIABLE error)
  if(NOT status STREQUAL expected OR NOT error MATCHES "${message}")
    message(FATAL_ERROR "status ${status} instead of ${expected}, \"${error}\" instead of \"${message}\"")
  endif()
endfunction()

file(READ ${OUT}/exam/polyps/candidates.csv candidates)
file(WRITE ${OUT}/exam/polyps/candidates.csv "${candidates}\n")
expect_status(3 "candidates.csv. was changed after the stage polyps wrote it")
file(WRITE ${OUT}/exam/polyps/candidates.csv "${candidates}")
expect_status(0 "")

file(READ ${OUT}/exam/stages/flattening.json record)
string(REGEX REPLACE "(\"segmentation/wall-simplified.vtp\": \")[0-9a-f]+" "\\10" older "${record}")
file(WRITE ${OUT}/exam/stages/flattening.json "${older}")
expect_status(3 "the stage flattening in .* were computed from an outdated .segmentation/wall-simplified.vtp")
file(WRITE ${OUT}/exam/stages/flattening.json "${record}")

file(REMOVE_RECURSE ${OUT}/exam/polyps)
expect_status(0 "")
if(DSRDUMP)
  execute_process(COMMAND ${DSRDUMP} ${OUT}/objects/cad.dcm OUTPUT_VARIABLE text ERROR_QUIET)
  if(NOT text MATCHES "No algorithms succeeded; without findings" OR NOT text MATCHES "Summary of Detections[^\n]*Not Attempted")
    message(FATAL_ERROR "the CAD report claims results of a search that was not run:\n${text}")
  endif()
endif()
